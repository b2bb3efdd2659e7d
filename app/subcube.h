/* subcube.h - one subcube: approximates F in the subcube and finds the polygons of all isosurfaces there. */
#ifndef SUBCUBE_H
#define SUBCUBE_H
#include "fit.h"
#include "grid.h"
#include "polygon.h"

#define ISOVALUES_MAX 16
#define LATTICE_MAX 4

struct isovalues {
    int n;
    double value[ISOVALUES_MAX];
};

/* Corner c's data are at corner[c]: one number (trilinear) or eight (tricubic). The result depends on the
 * arguments only: every node that computes a subcube finds the same polygons, to the bit. */
void trilinear_polygons(const struct cell *cell, const double *const corner[8], const struct isovalues *iso,
                        polygon_fn *out);

/* The cubic is polygonised on lattice x lattice x lattice small cubes, 1 <= lattice <= LATTICE_MAX. F - c may
 * have three roots on an edge of a small cube: `search` parts of the edge are searched for changes of sign,
 * and the first root counts. fit_prepare must have set the system up; if it was set up for other sides, it is
 * set up again. */
void tricubic_polygons(struct fit_system *system, const struct cell *cell, const double *const corner[8],
                       const struct isovalues *iso, int lattice, int search, polygon_fn *out);

/* F and its gradient with respect to u, v, w (0 to 1 across the subcube); b as in fit.h. */
double tricubic_value(const double b[64], double u, double v, double w);
void tricubic_gradient(const double b[64], const double at[3], double gradient[3]);

#endif
