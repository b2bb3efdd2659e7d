/* lookahead.h - for how long a program will make no call, as its checks tell the simulator (image.h: quiet).
 *
 * Of all ways from a check to the next call that the simulator may serve, or to the function's end, one is the cheapest: so
 * much is surely spent before. Loops make it more if nothing in them makes such a call, and their rounds are known where
 * they are entered. What the rounds to come will cost at least is kept in a variable, which only checks look at:
 *
 *     more = rounds * cheapest round
 *     loop:
 *         left -= cost
 *         if (left < 0) {
 *             quiet = min(quiet, left - cheapest way - more)
 *             preempt
 *         }
 *         more -= cheapest round
 *         ...
 *
 * What inner loops cost in a round is added, where their rounds are known before the outer one, too.
 *
 * A function that makes no such call is silent, and a call of it is none. Whether one in another file is, the linker says: a
 * byte of its name (write_silent). Where a loop calls functions that check for themselves, it makes its lookahead at each
 * round, in time for them.
 */
#ifndef NXCC_LOOKAHEAD_H
#define NXCC_LOOKAHEAD_H
#include "gcc.h"
#include <map>
#include <set>
#include <vector>

/* A loop's: more + add units, and if that may be negative, at least none. */
struct trips_to_come {
    tree more;
    int64_t add;
    bool at_least_0;
};

/* From a block's beginning on. */
struct lookahead {
    int64_t least = 0; /* the units of the cheapest way */
    std::vector<trips_to_come> more;
    bool callees_poll = false; /* functions that it calls check for themselves */
};

/* Finds the promises of blocks that check, where they are worth it. polled: heads of loops that run only when others cannot.
 * Statements in `own` are not the program's; those that keep `more` are added to them. */
std::map<basic_block, lookahead> lookahead_find(bitmap poll_blocks, const std::set<basic_block> &polled,
                                            std::set<gimple *> &added);
/* Appends quiet = min(quiet, left - what is promised, of which `paid` is spent). */
void lookahead_append(gimple_seq *seq, const lookahead &p, int64_t charged, tree word, tree left);
/* At the end of a file: which of its functions are call_free. */
void lookahead_write_flags();
#endif
