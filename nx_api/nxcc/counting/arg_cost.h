/* arg_cost.h - argument-dependent cost: what a library call costs by the values of its arguments or its
 * result. */
#ifndef NXCC_ARG_COST_H
#define NXCC_ARG_COST_H
#include "base/gcc.h"
#include "base/table.h"

/* Appends per * what the price counts (costs.h: costs_of_call). A count of more than 4 G, or a negative one,
 * is taken for none: an allocation that fails, an error code. */
tree arg_cost_append(gimple_seq *seq, gcall *call, int64_t per, const call_cost &price);
#endif
