/* trip_count.h - trip counts of loops, where they are known when the loop is entered.
 *
 * The trip count is GCC's niter: how often the loop goes back to its header. The header runs once more.
 */
#ifndef NXCC_TRIP_COUNT_H
#define NXCC_TRIP_COUNT_H
#include "base/gcc.h"

/* Can the trip count be computed, at small cost, where the loop is entered? Then *n describes it. */
bool trip_count_is_known(class loop *loop, tree_niter_desc *n);
/* The trip count if it is a constant, or -1. */
int64_t trip_count_constant(class loop *loop);
/* Appends the trip count; limit if it is limit or more, or if GCC's assumptions do not hold. */
tree trip_count_append(gimple_seq *seq, class loop *loop, const tree_niter_desc &n, int64_t limit);
#endif
