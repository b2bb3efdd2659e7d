/* purity.h - calls of functions that GCC has found pure or const.
 *
 * Such a function still changes the counter. Its callers are expanded with this knowledge, so it is taken away before each of
 * them is, for good.
 */
#ifndef NXCC_PURITY_H
#define NXCC_PURITY_H
#include "gcc.h"

/* This call changes something in memory. */
void purity_forget(gcall *call);
/* To be called before each function is optimised: its calls may be of functions that were pure before other callers were
 * compiled, and still say so. */
void purity_prepare_function();
#endif
