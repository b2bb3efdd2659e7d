/* race_update.h - writes of volatile variables whose value comes from a read of the same variable: count++,
 * but also top = height - 1; ... height = top. Being volatile makes a read and a write one step each, and not
 * the two together.
 *
 * The pass puts before each such write a telling with the flag NXC_RACE_UPDATE (contract/races.h). It follows
 * values through local variables of one function, after inlining; not through memory. */
#ifndef NXCC_RACE_UPDATE_H
#define NXCC_RACE_UPDATE_H
#include "base/gcc.h"

/* The pass that stands behind the counting pass, and before race_pass.h's. */
opt_pass *race_update_make_pass();
#endif
