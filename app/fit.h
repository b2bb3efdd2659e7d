/* fit.h - the trivariate cubic of a subcube from the C3 data of its corners. */
#ifndef FIT_H
#define FIT_H
#include "c3.h"

#define FIT_UNKNOWNS 64
#define FIT_PARTS 216 /* coefficients are multiples of 1/216 of a gray level */

/* One equation: a number of the C3 data is the sum of up to 8 coefficients times factors. Coefficients stand
 * in rising order of index. */
struct fit_equation {
    int terms;
    int index[8];
    double c[8];
};

/* The system of all subcubes of one size: its equations in the unit cube, and the Cholesky factor L of the
 * normal equations. */
struct fit_system {
    double widths[3];
    struct fit_equation equation[FIT_UNKNOWNS];
    int first[FIT_UNKNOWNS];              /* column of the first element of row i that is not zero */
    double l[FIT_UNKNOWNS][FIT_UNKNOWNS]; /* row i from first[i] to i */
};

/* Set the system up, and factor it, for subcubes with these sides, in pixels. The equations are the same for
 * all sides; they are set up for each size nevertheless, as in the program whose times were fitted to the
 * paper's. */
void fit_prepare(struct fit_system *s, const double widths[3]);

/* Find, in the sense of least squares, the Bernstein-Bezier coefficients b[16 i + 4 j + k] of a subcube's
 * (3,3,3) polynomial. corner[x + 2 y + 4 z] is the C3 data of corner (x, y, z), each 0 or 1, as c3_slice
 * makes them. Coefficients of a face, and their differences across it, depend on the data of the face's
 * corners only, to the bit. */
void fit_tricubic(const struct fit_system *s, const double *const corner[8], double b[FIT_UNKNOWNS]);

#endif
