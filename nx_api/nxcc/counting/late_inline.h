/* late_inline.h - inlining of functions that have been counted already.
 *
 * Compilers of the time inlined only what was declared so, and the clocks of each call are counted (`inlines`
 * of a cpu file). The host need not make these calls: when all of a function has been counted, the counted
 * bodies of small functions take the place of their calls. They charge and poll as the functions would, so
 * that no virtual time changes.
 *
 * A function can be inlined so if it makes no calls. Then no report of a call names it, and nothing in it is
 * another call where an argument is a constant. A copy of its body is kept when it is compiled; GCC compiles
 * callees first.
 */
#ifndef NXCC_LATE_INLINE_H
#define NXCC_LATE_INLINE_H
#include "base/gcc.h"

/* Registers the passes, to stand before the pass `before` and behind those that have been registered so. */
void late_inline_register(const char *plugin, const char *before);
#endif
