/* fit.h - the trivariate cubic of a subcube from the C3 data of its corners. */
#ifndef FIT_H
#define FIT_H
#include "c3.h"

#define FIT_UNKNOWNS 64

/* Find the Bernstein-Bezier coefficients b[16 i + 4 j + k] of the (3,3,3) polynomial of a subcube whose C3 data at
 * corner x + 2 y + 4 z (x, y, z = 0 or 1) is corner[..], in the least squares sense. widths: the subcube's sides. */
void fit_tricubic(const double *const corner[8], const double widths[3], double b[FIT_UNKNOWNS]);

#endif
