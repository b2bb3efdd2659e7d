/* counter_flow.h - the way of the counter through a function with inlined counted bodies.
 *
 * An inlined body loads the counter where it begins and stores it where it ends, and so do the places before
 * and behind its call. Most of that has no use: the counter's value is in a register, and nobody looks at
 * memory between. GCC's own passes must not do it: what they know of functions is from before the counting.
 */
#ifndef NXCC_COUNTER_FLOW_H
#define NXCC_COUNTER_FLOW_H
#include "base/gcc.h"

/* Replaces loads of the counter by the value that was stored or loaded before, and removes stores that nobody
 * reads. needs_counter: may a statement read or change the counter? */
void counter_flow_clean(function *fun, tree counter, bool (*needs_counter)(gimple *));
#endif
