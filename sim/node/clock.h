/* clock.h - a node's processor clock: cost units counted by the program, and the rest of its time. */
#ifndef NODE_CLOCK_H
#define NODE_CLOCK_H
#include "node/node.h"

/* The node's processor has so many clocks a second. */
void clock_set(struct node *n, uint64_t hz);
/* Take up what the program has spent since the last time; returns the time. */
vtime clock_sync(struct node *n);
/* Time goes on without the program: wait, system. t >= clock_sync(n). */
void clock_advance_to(struct node *n, vtime t);
/* Take back so much computing, or all there is. */
void clock_cut(struct node *n, vtime t);
/* Let the program spend until `deadline`: the first check at or past it calls nxc_preempt. Call after
 * clock_sync. */
void clock_allow(struct node *n, vtime deadline);
/* Virtual time of so many cost units. */
vtime clock_of_units(const struct node *n, uint64_t units);
#endif
