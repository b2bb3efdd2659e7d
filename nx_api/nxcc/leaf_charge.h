/* leaf_charge.h - functions that leave paying to their callers.
 *
 * A function that calls no other, has no loop and costs the same on every way through it need not count: whoever calls it
 * adds its cost to what the call costs, and such a call is no reason to store the counter. That takes a function
 * all of whose callers are known, and still to be compiled; GCC compiles callees first.
 */
#ifndef NXCC_LEAF_CHARGE_H
#define NXCC_LEAF_CHARGE_H
#include "gcc.h"

/* Is it a call of one? */
bool leaf_charge_is_call(gimple *stmt);
/* The units of its body; 0 for all other statements. */
int64_t leaf_charge_cost(gimple *stmt);
/* To be told of every call in a function when that is compiled. */
void leaf_charge_note_call(gcall *call);
/* To be asked of every function: is it one of these from now on, so that it does not count? */
bool leaf_charge_accept(function *fun);
#endif
