/* bells.h - the bell that a sender's library rings when it has sent to a node of the same computer: it sets
 * the receiver's nxc_due, which lies in shared memory, so that the next poll of a computing program takes
 * the message in; and it wakes a receiver that sleeps in its wait. A ring costs the receiver nothing when
 * it does not come, unlike a clock that ticks often.
 *
 * Nodes of other computers do not ring; nor do any where there is no shared memory. Then the clock ticks
 * more often (tick.h). A ring may be missed, in the moment in which a program posts its first handler or
 * goes to sleep: the clock, or the end of the sleep, makes up for it. */
#ifndef MPI_BELLS_H
#define MPI_BELLS_H
#include <stdatomic.h>
#include "backend_node.h"

/* Set: a poll of the program is to call nxc_preempt. */
extern volatile int nxc_due;

/* The first bytes of a node's page. */
struct bell {
    atomic_int due;    /* nxc_due */
    atomic_int wanted; /* of the following */
};
enum { BELL_RINGS = 1, BELL_WAKES = 2 };

extern struct bell **bells __attribute__((visibility("hidden"))); /* by node; NULL: of another computer */

/* For wire_begin, on all nodes. True: all nodes have bells. */
bool bells_begin(const struct node *n);
/* This node wants to be rung for, from now on. */
void bell_want(void);
/* Ends what nxc_due says; what has been sent before is to be looked for after that. */
bool bell_take(void);
/* Sleeps till somebody rings, or that time has passed. */
void bell_sleep(long ns);

/* Wakes this node itself, from another thread. */
void bell_ring_here(void);

void bell_ring_now(struct bell *b, int wanted);
/* A message has been sent to a node. */
static inline void bell_ring(long node)
{
    struct bell *b = bells[node];
    int wanted = b ? atomic_load_explicit(&b->wanted, memory_order_relaxed) : 0;
    if (wanted)
        bell_ring_now(b, wanted);
}
#endif
