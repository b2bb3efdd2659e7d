/* c3.h - the data at the grid points of a slice: C0 data (the gray level) or C3 data (level and 7
 * derivatives).
 */
#ifndef C3_H
#define C3_H
#include "grid.h"
#include "slice.h"

/* C3 data of a grid point, in this order. */
enum { F, F_X, F_Y, F_Z, F_XY, F_YZ, F_XZ, F_XYZ, C3_COMPS };

/* Gray levels at the grid points of one slice; out has (ny+1) rows of nx+1 doubles. */
void c0_slice(const struct grid *g, const pixel *image, double *out);

/* C3 data by finite differences from a slice and its neighbours; out has (ny+1) rows of nx+1 points of 8
 * doubles. below (above) is NULL at the bottom (top) of the volume: the slice itself replaces it. */
void c3_slice(const struct grid *g, const pixel *below, const pixel *image, const pixel *above, double *out);

#endif
