/* fit.h - the trivariate cubic of a subcube from the C3 data of its corners. */
#ifndef FIT_H
#define FIT_H
#include "c3.h"

#define FIT_UNKNOWNS 64

/* One equation: a number of the C3 data is a sum of up to 8 coefficients with factors, in rising order of
 * index. */
struct fit_equation {
    int terms;
    int index[8];
    double c[8];
};

/* The system of all subcubes of one size: its equations, and the Cholesky factor of their normal equations.
 */
struct fit_system {
    double widths[3];
    struct fit_equation equation[FIT_UNKNOWNS];
    int first[FIT_UNKNOWNS];              /* column of the first element of row i that is not zero */
    double l[FIT_UNKNOWNS][FIT_UNKNOWNS]; /* row i from first[i] to i */
};

/* Set the system up for subcubes with these sides. */
void fit_prepare(struct fit_system *s, const double widths[3]);

/* Find the Bernstein-Bezier coefficients b[16 i + 4 j + k] of the (3,3,3) polynomial of a subcube whose C3
 * data at corner x + 2 y + 4 z (x, y, z = 0 or 1) is corner[..], in the least squares sense. */
void fit_tricubic(const struct fit_system *s, const double *const corner[8], double b[FIT_UNKNOWNS]);

#endif
