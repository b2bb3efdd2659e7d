/* loop_precharge.h - loop pre-charging: a loop whose whole cost is charged where it is entered.
 *
 * A loop can be precharged if its trip count is known where it is entered and no statement in it needs the
 * counter. Such a loop is made twice; the second is its *polled version*:
 *
 *     need = trip count * cost of a trip
 *     if (left - need >= 0) {
 *         left -= need
 *         the loop as the program has it          no poll in it could strike
 *     } else
 *         the polled version                      charges each block and polls in each trip
 *
 * Both versions charge the same, and polls strike at the same places as if there were the polled version
 * alone. If trips differ in cost, the test uses the costliest trip, the charge ahead is for the blocks that
 * all trips run, and the other blocks are charged as they run. An inner loop of few trips, whose number is a
 * constant, is part of the trip.
 */
#ifndef NXCC_LOOP_PRECHARGE_H
#define NXCC_LOOP_PRECHARGE_H
#include "base/gcc.h"
#include <set>
#include <vector>

/* A block that runs trips * each + last times when the loop runs. */
struct precharged_block {
    basic_block bb;
    int64_t each, last;
};

struct precharged_loop {
    gcond *test;       /* true leads to the precharged version; its condition is still to be made */
    basic_block first; /* the first block on the way to the precharged version */
    tree trips;        /* the trip count, or limit if that is not known */
    int64_t limit;
    int64_t most; /* units of the costliest trip */
    std::vector<precharged_block> blocks;
};

struct precharge_plan {
    std::vector<precharged_loop> loops;
    std::set<basic_block> polled; /* heads of the polled versions */
    std::set<gimple *> added;     /* statements of the plugin: trip counts and tests */
};

/* Makes the polled versions and finds what to charge. needs_counter: may a statement read or change the
 * counter? poll_blocks: the blocks that poll; those of the precharged versions are taken out. */
precharge_plan loop_precharge_run(bool (*needs_counter)(gimple *), bitmap poll_blocks);
#endif
