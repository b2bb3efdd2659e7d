/* trip_count.h - how often a loop goes back to its beginning, where that is known when it is entered. */
#ifndef NXCC_TRIP_COUNT_H
#define NXCC_TRIP_COUNT_H
#include "gcc.h"

/* Is it known, or can be computed where the loop is entered? Most loops' numbers are right without assumptions. */
bool trip_count_is_known(class loop *loop, tree_niter_desc *n);
/* Always the same, or -1. */
int64_t trip_count_constant(class loop *loop);
/* Appends the number of rounds: limit if it is that or greater, or if the assumptions are wrong. */
tree trip_count_append(gimple_seq *seq, class loop *loop, const tree_niter_desc &n, int64_t limit);
#endif
