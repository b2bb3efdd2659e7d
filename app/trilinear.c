/* trilinear.c - the (1,1,1) approximation: F is trilinear in each subcube, and continuous (C0).
 *
 * The Bernstein-Bezier coefficients of F are the gray levels in the corners. F is linear along an edge: if F
 * - c changes its sign between the ends of an edge, one division gives the root. Every edge of every subcube
 * is examined for every isovalue, as in the (3,3,3) approximation.
 */
#include "subcube.h"

static inline double mix(double a, double b, double t)
{
    return a * (1.0 - t) + b * t;
}

static void gradient(const double f[8], const double at[3], double g[3])
{
    double u = at[0], v = at[1], w = at[2];

    g[0] = mix(mix(f[1] - f[0], f[3] - f[2], v), mix(f[5] - f[4], f[7] - f[6], v), w);
    g[1] = mix(mix(f[2] - f[0], f[3] - f[1], u), mix(f[6] - f[4], f[7] - f[5], u), w);
    g[2] = mix(mix(f[4] - f[0], f[5] - f[1], u), mix(f[6] - f[2], f[7] - f[3], u), v);
}

/* p becomes the point of edge e where F = c. Answers 0 if F - c does not change its sign along the edge. */
static int crossing(const double f[8], double c, int e, double p[3])
{
    int d = e >> 2, start = polygon_edge[e][0];
    double from = f[start], to = f[polygon_edge[e][1]];

    if ((from < c) == (to < c))
        return 0;
    p[0] = start & 1;
    p[1] = start >> 1 & 1;
    p[2] = start >> 2 & 1;
    p[d] = (c - from) / (to - from);
    return 1;
}

static void place(const struct cell *cell, const double f[8], const double p[3], vertex v)
{
    v[0] = cell->x + p[0] * cell->wx;
    v[1] = cell->y + p[1] * cell->wy;
    v[2] = (cell->layer + p[2]) * cell->dz;
    gradient(f, p, v + 3);
    v[3] /= cell->wx;
    v[4] /= cell->wy;
    v[5] /= cell->dz;
    polygon_normalise(v + 3);
}

/* The polygons of one isosurface F = c. */
static void surface(const struct cell *cell, const double f[8], double c, int number, polygon_fn *out)
{
    vertex at[12];
    const vertex *at_edge[12];
    double p[3];
    unsigned inside = 0;
    int e;

    for (e = 0; e < 12; e++) {
        at_edge[e] = &at[e];
        if (crossing(f, c, e, p))
            place(cell, f, p, at[e]);
    }
    for (e = 0; e < 8; e++)
        inside |= (unsigned)(f[e] < c) << e;
    polygon_link(inside, at_edge, number, out);
}

void trilinear_polygons(const struct cell *cell, const double *const corner[8], const struct isovalues *iso,
                        polygon_fn *out)
{
    double f[8];
    int i;

    for (i = 0; i < 8; i++)
        f[i] = corner[i][0];
    for (i = 0; i < iso->n; i++)
        surface(cell, f, iso->value[i], i, out);
}
