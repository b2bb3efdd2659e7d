/* subcube.h - the work of the slaves: approximate F in one subcube and find the polygons of all isosurfaces
 * in it. */
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

/* Corner c's data are at corner[c]: one number (trilinear) or eight (tricubic). The result depends on nothing
 * but the arguments: whoever computes a subcube finds the same polygons, to the bit. */
void trilinear_polygons(const struct cell *cell, const double *const corner[8], const struct isovalues *iso,
                        polygon_fn *out);

/* The cubic is polygonised on lattice x lattice x lattice small cubes, 1 <= lattice <= LATTICE_MAX. A cubic
 * may cross an edge of theirs three times: `search` parts of it are looked at for a change of sign, and the
 * first root is taken. The system must be one that fit_prepare has set up; it is set up anew when the
 * subcube's sides are not those it was made for. */
void tricubic_polygons(struct fit_system *system, const struct cell *cell, const double *const corner[8],
                       const struct isovalues *iso, int lattice, int search, polygon_fn *out);

/* F and its gradient with respect to u, v, w (0 to 1 across the subcube); b as in fit.h. */
double tricubic_value(const double b[64], double u, double v, double w);
void tricubic_gradient(const double b[64], const double at[3], double gradient[3]);

#endif
