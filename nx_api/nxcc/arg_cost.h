/* arg_cost.h - argument-dependent cost: what a library call costs by the values of its arguments or its
 * result. */
#ifndef NXCC_ARG_COST_H
#define NXCC_ARG_COST_H
#include "gcc.h"
#include <vector>

/* Appends per * the product of the values that `of` lists (costs.h: costs_of_call). NULL if one of them is no
 * integer, or no array where elements are counted. */
tree arg_cost_append(gimple_seq *seq, gcall *call, int64_t per, const std::vector<int> &of, bool elements);
#endif
