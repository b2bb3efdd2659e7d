/* purity.h - calls of functions that GCC has found pure or const.
 *
 * GCC takes it that such a call changes nothing in memory, but a counted function changes the counter. So the
 * plugin takes the attribute away from the function, for good, before the code of a caller is made.
 */
#ifndef NXCC_PURITY_H
#define NXCC_PURITY_H
#include "base/gcc.h"

/* From now on this call changes something in memory. */
void purity_forget(gcall *call);
/* To be called before a function is optimised: brings calls up to date whose callees lost the attribute when
 * other callers were compiled. */
void purity_prepare_function();
#endif
