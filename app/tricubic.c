/* tricubic.c - the (3,3,3) approximation: F is a trivariate cubic in each subcube, and C1 across their
 * faces.
 *
 * The surface of a cubic can bend within a subcube, so that F is polygonised on a lattice of m x m x m
 * small cubes. Whether a lattice point is inside is decided once, from the value of F there. F never
 * equals an isovalue at a lattice point (options.c), or polygons would shrink to points. F is restricted
 * to each lattice edge once; the root for each isovalue is then sought along every edge.
 *
 * Neighbouring subcubes decide alike and find the same vertices, to the bit: their coefficients on a face
 * are equal (fit.c), and all others are multiplied there by a Bernstein polynomial that is 0.
 */
#include <math.h>
#include <string.h>
#include "fit.h"
#include "subcube.h"

#define POINTS_MAX ((LATTICE_MAX + 1) * (LATTICE_MAX + 1) * (LATTICE_MAX + 1))

/* Lattice point (i, j, k) has number i * stride[0] + j * stride[1] + k * stride[2]; the edge from it along
 * axis d has the same number in edge[d]. */
struct lattice {
    int m, search, stride[3];
    double value[POINTS_MAX];
    double edge[3][POINTS_MAX][4]; /* F along the edge, as a Bernstein-Bezier cubic */
};

static inline double mix(double a, double b, double t)
{
    return a + (b - a) * t;
}

static void bernstein(double t, double w[4])
{
    double s = 1.0 - t;

    w[0] = s * s * s;
    w[1] = 3 * s * s * t;
    w[2] = 3 * s * t * t;
    w[3] = t * t * t;
}

static void bernstein_derivative(double t, double w[4])
{
    double s = 1.0 - t;

    w[0] = -3 * s * s;
    w[1] = 3 * s * s - 6 * s * t;
    w[2] = 6 * s * t - 3 * t * t;
    w[3] = 3 * t * t;
}

static double contract(const double b[64], const double x[4], const double y[4], const double z[4])
{
    double sum = 0;
    int i, j;

    for (i = 0; i < 4; i++)
        for (j = 0; j < 4; j++, b += 4)
            sum += x[i] * y[j] * (b[0] * z[0] + b[1] * z[1] + b[2] * z[2] + b[3] * z[3]);
    return sum;
}

double tricubic_value(const double b[64], double u, double v, double w)
{
    double x[4], y[4], z[4];

    bernstein(u, x);
    bernstein(v, y);
    bernstein(w, z);
    return contract(b, x, y, z);
}

void tricubic_gradient(const double b[64], const double at[3], double gradient[3])
{
    double w[3][4], dw[3][4];
    int d;

    for (d = 0; d < 3; d++) {
        bernstein(at[d], w[d]);
        bernstein_derivative(at[d], dw[d]);
    }
    gradient[0] = contract(b, dw[0], w[1], w[2]);
    gradient[1] = contract(b, w[0], dw[1], w[2]);
    gradient[2] = contract(b, w[0], w[1], dw[2]);
}

/* De Casteljau's algorithm on a univariate cubic: its value if r = s = t, its blossom otherwise. */
static inline double blossom(const double q[4], double r, double s, double t)
{
    double a = mix(q[0], q[1], r), b = mix(q[1], q[2], r), c = mix(q[2], q[3], r);

    return mix(mix(a, b, s), mix(b, c, s), t);
}

/* F along the line in direction d through the lattice points (a, b) of the other two axes. */
static void restrict_to_line(const double b[64], int d, double s, double t, double q[4])
{
    static const int step[3] = {16, 4, 1};
    int along = step[d], first = step[d == 0], second = step[d == 2 ? 1 : 2], i, j, k;
    double ws[4], wt[4];

    bernstein(s, ws);
    bernstein(t, wt);
    for (i = 0; i < 4; i++)
        for (q[i] = 0, j = 0; j < 4; j++)
            for (k = 0; k < 4; k++)
                q[i] += b[i * along + j * first + k * second] * ws[j] * wt[k];
}

/* Cut the line into the lattice's edges. At its ends an edge takes the lattice values, to the bit. */
static void cut_line(struct lattice *l, const double q[4], int d, int start)
{
    double h = 1.0 / l->m;
    int i, n = start;

    for (i = 0; i < l->m; i++, n += l->stride[d]) {
        double *edge = l->edge[d][n], t0 = i * h, t1 = (i + 1) * h;

        edge[0] = l->value[n];
        edge[1] = blossom(q, t0, t0, t1);
        edge[2] = blossom(q, t0, t1, t1);
        edge[3] = l->value[n + l->stride[d]];
    }
}

static void set_lattice(struct lattice *l, const double b[64], int m)
{
    double h = 1.0 / m, q[4];
    int d, i, j, k, n = 0;

    l->m = m;
    l->stride[0] = (m + 1) * (m + 1);
    l->stride[1] = m + 1;
    l->stride[2] = 1;
    for (i = 0; i <= m; i++)
        for (j = 0; j <= m; j++)
            for (k = 0; k <= m; k++)
                l->value[n++] = tricubic_value(b, i * h, j * h, k * h);
    for (d = 0; d < 3; d++)
        for (i = 0; i <= m; i++)
            for (j = 0; j <= m; j++) {
                restrict_to_line(b, d, i * h, j * h, q);
                cut_line(l, q, d, i * l->stride[d == 0] + j * l->stride[d == 2 ? 1 : 2]);
            }
}

/* The root of q - c between t0 and t1, where q - c is f0 and f1, by false position (Illinois rule). */
static double draw_together(const double q[4], double c, double t0, double f0, double t1, double f1)
{
    double t = t0, f;
    int i;

    for (i = 0; i < 50 && fabs(t1 - t0) > 1e-12; i++) {
        t = t1 - f1 * (t1 - t0) / (f1 - f0);
        f = blossom(q, t, t, t) - c;
        if (f == 0)
            break;
        if ((f < 0) != (f1 < 0)) {
            t0 = t1;
            f0 = f1;
        } else
            f0 *= 0.5;
        t1 = t;
        f1 = f;
    }
    return t;
}

/* Seek the roots of q - c along an edge, part by part. Answers how many changes of sign there are; *root is
 * the first root. */
static int seek(const double q[4], double c, int parts, double *root)
{
    double last = q[0] - c, now, part = 1.0 / parts;
    int i, found = 0;

    for (i = 1; i <= parts; i++, last = now) {
        double t = i * part;

        now = i < parts ? blossom(q, t, t, t) - c : q[3] - c;
        if ((last < 0) != (now < 0) && ++found == 1)
            *root = draw_together(q, c, t - part, last, t, now);
    }
    return found;
}

/* at: the vertex's position in the subcube, 0 to 1 along each axis */
static void place(const struct cell *cell, const double b[64], const double at[3], vertex v)
{
    v[0] = cell->x + at[0] * cell->wx;
    v[1] = cell->y + at[1] * cell->wy;
    v[2] = (cell->layer + at[2]) * cell->dz;
    tricubic_gradient(b, at, v + 3);
    v[3] /= cell->wx;
    v[4] /= cell->wy;
    v[5] /= cell->dz;
    polygon_normalise(v + 3);
}

/* Find the vertices of F = c on all lattice edges. An edge with an even number of roots has no vertex: the
 * surface turns back between two lattice points, which only a finer lattice would show. */
static void cross_edges(const struct cell *cell, const double b[64], const struct lattice *l, double c,
                        vertex crossing[3][POINTS_MAX])
{
    int m = l->m, d, i[3], n;
    double root = 0;

    for (d = 0; d < 3; d++)
        for (i[0] = 0; i[0] <= m - (d == 0); i[0]++)
            for (i[1] = 0; i[1] <= m - (d == 1); i[1]++)
                for (i[2] = 0; i[2] <= m - (d == 2); i[2]++) {
                    n = i[0] * l->stride[0] + i[1] * l->stride[1] + i[2];
                    if (seek(l->edge[d][n], c, l->search, &root) & 1) {
                        double at[3] = {i[0], i[1], i[2]};

                        at[d] += root;
                        at[0] /= m;
                        at[1] /= m;
                        at[2] /= m;
                        place(cell, b, at, crossing[d][n]);
                    }
                }
}

/* Link the crossings of the small cube whose lowest lattice point is n. */
static void link_cube(const struct lattice *l, double c, int n, vertex crossing[3][POINTS_MAX], int number,
                      polygon_fn *out)
{
    const vertex *at_edge[12];
    int corner[8], e;
    unsigned inside = 0;

    for (e = 0; e < 8; e++) {
        corner[e] = n + (e & 1) * l->stride[0] + (e >> 1 & 1) * l->stride[1] + (e >> 2) * l->stride[2];
        inside |= (unsigned)(l->value[corner[e]] < c) << e;
    }
    if (inside == 0 || inside == 255)
        return;
    for (e = 0; e < 12; e++)
        at_edge[e] = &crossing[e >> 2][corner[polygon_edge[e][0]]];
    polygon_link(inside, at_edge, number, out);
}

void tricubic_polygons(struct fit_system *system, const struct cell *cell, const double *const corner[8],
                       const struct isovalues *iso, int lattice, int search, polygon_fn *out)
{
    const double widths[3] = {cell->wx, cell->wy, cell->dz};
    double b[FIT_UNKNOWNS];
    struct lattice l;
    vertex crossing[3][POINTS_MAX];
    int s, i, j, k;

    if (memcmp(system->widths, widths, sizeof widths))
        fit_prepare(system, widths); /* the last subcube of a row or column may be narrower */
    fit_tricubic(system, corner, b);
    set_lattice(&l, b, lattice);
    l.search = search;
    for (s = 0; s < iso->n; s++) {
        cross_edges(cell, b, &l, iso->value[s], crossing);
        for (i = 0; i < lattice; i++)
            for (j = 0; j < lattice; j++)
                for (k = 0; k < lattice; k++)
                    link_cube(&l, iso->value[s], i * l.stride[0] + j * l.stride[1] + k, crossing, s, out);
    }
}
