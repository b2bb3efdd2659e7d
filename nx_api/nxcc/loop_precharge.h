/* loop_precharge.h - loops that are paid for where they are entered.
 *
 * If it is known there how many rounds a loop will make, and that nobody looks at the counter before it is left, its cost
 * can be known there too. Such a loop is made twice:
 *
 *     need = rounds * cost of a round
 *     if (left - need >= 0) {
 *         left -= need
 *         the loop, as the program has it         no check in it could find left negative
 *     } else
 *         the loop, paying and checking as it goes
 *
 * so that the same is paid, and checks strike at the same places, as in the second alone. Where rounds differ, a round
 * pays ahead for what all have in common, the blocks of some rounds only pay when they run, and the test is for
 * the dearest rounds. Inner loops of few rounds, of a number known when compiled, are part of the round.
 */
#ifndef NXCC_LOOP_PRECHARGE_H
#define NXCC_LOOP_PRECHARGE_H
#include "gcc.h"
#include <set>
#include <vector>

/* A block that runs rounds * each + last times when a loop runs. */
struct precharged_block {
    basic_block bb;
    int64_t each, last;
};

struct precharged_loop {
    gcond *test;       /* to be made: true leads to the loop that does not pay */
    basic_block first; /* of the way there */
    tree trips;       /* how often the loop goes back; unknown: it is the limit */
    int64_t limit;
    int64_t most; /* units of a round, and of the last, at most */
    std::vector<precharged_block> blocks;
};

struct precharge_plan {
    std::vector<precharged_loop> loops;
    std::set<basic_block> polled; /* heads of those that pay as they go */
    std::set<gimple *> added;     /* statements that compute rounds, and tests: not the program's */
};

/* Makes the copies and finds what is to be paid. looks: may this statement look at the counter? checked: blocks that are
 * to check; those of the loops that do not pay are taken out. */
precharge_plan loop_precharge_run(bool (*needs_counter)(gimple *), bitmap poll_blocks);
#endif
