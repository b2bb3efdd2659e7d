/* trilinear.c - the (1,1,1) approximation: F is trilinear in each subcube, and continuous (C0).
 *
 * Its Bernstein-Bezier coefficients are the gray levels in the corners. For each isovalue the root of F is sought along
 * every edge. The seeker knows F by its values only: it looks at equidistant points of the edge for a change of sign
 * and then draws the interval together.
 */
#include <math.h>
#include "subcube.h"

#define INTERVALS 2

static double mix(double a, double b, double t)
{
    return a * (1.0 - t) + b * t;
}

static double value(const double f[8], double u, double v, double w)
{
    return mix(mix(mix(f[0], f[1], u), mix(f[2], f[3], u), v), mix(mix(f[4], f[5], u), mix(f[6], f[7], u), v),
               w);
}

static void gradient(const double f[8], const double at[3], double g[3])
{
    double u = at[0], v = at[1], w = at[2];

    g[0] = mix(mix(f[1] - f[0], f[3] - f[2], v), mix(f[5] - f[4], f[7] - f[6], v), w);
    g[1] = mix(mix(f[2] - f[0], f[3] - f[1], u), mix(f[6] - f[4], f[7] - f[5], u), w);
    g[2] = mix(mix(f[4] - f[0], f[5] - f[1], u), mix(f[6] - f[2], f[7] - f[3], u), v);
}

/* F - c at parameter t of the edge that starts at p along axis d; p comes back as the point. */
static double along(const double f[8], double c, double p[3], int d, double t)
{
    p[d] = t;
    return value(f, p[0], p[1], p[2]) - c;
}

/* The root of F - c between t0 and t1, where it is f0 and f1, by false position (Illinois rule). */
static double draw_together(const double f[8], double c, double p[3], int d, double t0, double f0, double t1,
                            double f1)
{
    double t = t0, ft;
    int i;

    for (i = 0; i < 50 && fabs(t1 - t0) > 1e-12; i++) {
        t = t1 - f1 * (t1 - t0) / (f1 - f0);
        ft = along(f, c, p, d, t);
        if (ft == 0)
            break;
        if ((ft < 0) != (f1 < 0)) {
            t0 = t1;
            f0 = f1;
        } else
            f0 *= 0.5;
        t1 = t;
        f1 = ft;
    }
    return t;
}

/* Seek the root of F - c along edge e. If there is one, p becomes its place and the answer is 1. */
static int seek(const double f[8], double c, int e, double p[3])
{
    int d = e >> 2, start = polygon_edge[e][0], i;
    double last, now;

    p[0] = start & 1;
    p[1] = start >> 1 & 1;
    p[2] = start >> 2 & 1;
    last = along(f, c, p, d, 0.0);
    for (i = 1; i <= INTERVALS; i++, last = now) {
        now = along(f, c, p, d, i * (1.0 / INTERVALS));
        if ((last < 0) != (now < 0)) {
            p[d] = draw_together(f, c, p, d, (i - 1) * (1.0 / INTERVALS), last, i * (1.0 / INTERVALS), now);
            return 1;
        }
    }
    return 0;
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
        if (seek(f, c, e, p))
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
