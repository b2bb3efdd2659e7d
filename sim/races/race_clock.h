/* race_clock.h - vector clocks with two components a node: what a strand (a node's main program, or its
 * handlers) has heard of the other strands (Lamport 1978, Mattern 1989).
 *
 * A strand counts epochs. It has heard of an epoch of another strand if that epoch lies before it in the
 * order that calls and messages make. Node i's main program has component 2 i, its handlers have 2 i + 1;
 * so a clock of N nodes takes 16 N bytes. Clocks are shared: by strands that have heard the same, and by
 * messages. A shared clock does not change; joining makes a new one. References are counted atomically, for
 * programs on several threads may let go of one clock. NULL is the clock that has heard of nothing. */
#ifndef RACES_RACE_CLOCK_H
#define RACES_RACE_CLOCK_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct race_clock;

/* What is known of one node's two strands. */
struct race_known {
    uint64_t main, handlers;
};

struct race_clock *race_clock_share(struct race_clock *c);
void race_clock_free(struct race_clock *c);
struct race_known race_clock_of(const struct race_clock *c, uint32_t node);
/* *c hears of all that `other` has, and of `known` at `node`. Frees or changes the old clock; nothing is
 * made where nothing is new. */
void race_clock_join(struct race_clock **c, const struct race_clock *other);
void race_clock_hear(struct race_clock **c, uint32_t node, struct race_known known);
/* Has a heard of all that b has? */
bool race_clock_includes(const struct race_clock *a, const struct race_clock *b);
#endif
