/* lookahead.h - a program's lookahead: the cost units that it certainly spends before its next call.
 *
 * A *call* is here one that the simulator may serve. When a poll strikes (left < 0), the program stores in
 * its image the value that its counter will have come down to, at the latest, at its next call (image.h:
 * lookahead). No other node has to wait for the program before then.
 *
 * The cheapest path from a poll to the next call, or to the function's end, is a lower bound on the computing
 * before it:
 *
 *     lookahead = min over paths (sum of the blocks' costs) + remaining trips of the loops around the poll
 *
 * Where a path enters a loop without calls, the path costs  least trip count * cheapest trip  more. For a
 * loop around the poll, the units of the trips still to come are kept in a variable, `remaining`, which only
 * polls read:
 *
 *     remaining = trips * cheapest trip
 *     loop:
 *         left -= cost
 *         if (left < 0) {
 *             lookahead = min(lookahead, left - cheapest path - remaining)
 *             preempt
 *         }
 *         remaining -= cheapest trip
 *         ...
 *
 * An inner loop whose trip count is known where the outer loop is entered adds its units to the outer loop's
 * cheapest trip.
 *
 * A function is *call-free* if it reaches no call; calling it does not end the lookahead (call_free.h). A
 * loop that calls functions with polls of their own stores its lookahead in each trip, since the polls that
 * strike may be theirs.
 *
 * A call before the end of the lookahead is a bug of this plugin. The simulator then stops the run, and names
 * the call and the function (sim/lp/clock.h: clock_lookahead_is_broken).
 */
#ifndef NXCC_LOOKAHEAD_H
#define NXCC_LOOKAHEAD_H
#include "base/gcc.h"
#include <map>
#include <set>
#include <vector>

/* The units of a loop's trips to come: remaining + add; 0 if the sum may be negative and is. */
struct remaining_trips {
    tree remaining;
    int64_t add;
    bool at_least_0;
};

/* The lookahead at the beginning of a block. */
struct lookahead {
    int64_t least = 0; /* the units of the cheapest path */
    std::vector<remaining_trips> loops;
    bool callees_poll = false; /* functions that the block's loop calls have polls of their own */
};

/* The lookahead of each block in poll_blocks, where it is worth its code. polled: heads of the polled
 * versions of precharged loops, which run seldom. added: statements of the plugin, which cost nothing; those
 * that keep `remaining` are added. */
std::map<basic_block, lookahead> lookahead_find(bitmap poll_blocks, const std::set<basic_block> &polled,
                                                std::set<gimple *> &added);
/* Appends word = min(word, left - lookahead). Of the lookahead, `charged` units have been taken off left
 * already. */
void lookahead_append(gimple_seq *seq, const lookahead &p, int64_t charged, tree word, tree left);
#endif
