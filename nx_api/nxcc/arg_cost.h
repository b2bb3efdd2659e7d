/* arg_cost.h - the part of a library call's cost that its arguments or result tell. */
#ifndef NXCC_ARG_COST_H
#define NXCC_ARG_COST_H
#include "gcc.h"
#include <vector>

/* Appends per * the product of the values that `of` lists, as costs_of_call has them. NULL if one of them is not what it
 * should be. */
tree arg_cost_append(gimple_seq *seq, gcall *call, int64_t per, const std::vector<int> &of, bool elements);
#endif
