/* race_loops.h - accesses of innermost loops that go through memory without gaps, told as one range where the
 * loop is left, and before a poll in it preempts:
 *
 *     first = address                          where the loop is entered
 *     loop:  if (left < 0) { tell from first to address; preempt; first = address; }
 *            ... *address ...; address += size of the access
 *     tell from first to address               where the loop is left
 *
 * Between two of these places nothing that others do can come between the accesses, so it does not matter
 * when the simulator hears of them. A loop over an array is as fast as without reports. */
#ifndef NXCC_RACE_LOOPS_H
#define NXCC_RACE_LOOPS_H
#include "base/gcc.h"
#include <vector>

/* An access to be told as a range. */
struct race_loop_access {
    gimple *stmt;
    tree ref;
    bool write;
    class loop *loop;
    tree varying;  /* the one operand of ref that changes from trip to trip */
    gphi *value;   /* it, or of which it is a conversion, where the loop begins a trip */
    int64_t bytes; /* of one access */
    bool down;     /* the address falls */
};

/* The accesses of the function's loops that can be told so. To be called when the loops' structure and the
 * dominators are known. */
std::vector<race_loop_access> race_loops_find(function *fun);
/* Inserts the telling, with a site of the file's table, on edges that the caller has to commit. */
void race_loops_tell(const race_loop_access &access, size_t site);
#endif
