/* leaf_charge.h - caller-charged leaf functions.
 *
 * A function that calls no other, has no loop and costs the same on all paths need not count: each caller
 * adds the function's cost to its own, and need not store the counter for the call. All callers must be known
 * and still to be compiled; GCC compiles callees first.
 */
#ifndef NXCC_LEAF_CHARGE_H
#define NXCC_LEAF_CHARGE_H
#include "base/gcc.h"

/* Is stmt a call of a caller-charged leaf? */
bool leaf_charge_is_call(gimple *stmt);
/* The units of the leaf that stmt calls; 0 for all other statements. */
int64_t leaf_charge_cost(gimple *stmt);
/* To be called for each call in a function when that function is compiled. */
void leaf_charge_note_call(gcall *call);
/* To be called for each function: makes it a caller-charged leaf, which does not count, if it can be one. */
bool leaf_charge_accept(function *fun);
#endif
