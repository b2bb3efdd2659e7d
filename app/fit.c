/* fit.c - least squares fit of a trivariate cubic to C3 data.
 *
 * 8 corners with 8 numbers each give 64 equations A b = d in the 64 coefficients. fit_prepare factors the
 * matrix of the normal equations A'A b = A'd by Cholesky's method. An equation joins only coefficients
 * whose indices differ by at most one in each direction, so that the rows of A'A begin with zeros. The
 * Cholesky factor keeps this profile, and all loops begin at a row's first element that is not zero. The
 * fit is solved in the unit cube: a subcube's derivatives are first multiplied by its sides, so that the
 * equations are as well conditioned for flat subcubes as for others. Each subcube's data then take two
 * substitutions.
 *
 * The value and the normal derivative of F on a face depend on the data of the face's corners only:
 * neighbouring subcubes join with C1 continuity. They must also meet to the bit, or a surface has holes
 * where their rounding differs. Gray levels and sides in pixels are whole numbers, a difference is divided
 * by 1 or 2, and an equation's factors are powers of 3: the coefficients are multiples of 1/216. Rounded
 * to such multiples they are free of the fit's own rounding.
 */
#include <math.h>
#include <string.h>
#include "fit.h"

/* One univariate functional on cubic Bernstein coefficients: value or derivative at one end of an edge. */
struct functional {
    int terms, first;
    double c[2];
};

static struct functional at_end(int end, int derivative)
{
    struct functional l;

    if (derivative) {
        l.terms = 2;
        l.first = end ? 2 : 0;
        l.c[0] = -3.0;
        l.c[1] = 3.0;
    } else {
        l.terms = 1;
        l.first = end ? 3 : 0;
        l.c[0] = 1.0;
        l.c[1] = 0.0;
    }
    return l;
}

/* The equation of a product of three functionals. */
static void product(struct fit_equation *e, const struct functional *x, const struct functional *y,
                    const struct functional *z)
{
    int i, j, k, n = 0;

    for (i = 0; i < x->terms; i++)
        for (j = 0; j < y->terms; j++)
            for (k = 0; k < z->terms; k++) {
                e->index[n] = 16 * (x->first + i) + 4 * (y->first + j) + z->first + k;
                e->c[n++] = x->c[i] * y->c[j] * z->c[k];
            }
    e->terms = n;
}

/* For each number of the C3 data: is it a derivative along x, y, z? */
static const int derivative[C3_COMPS][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                            {1, 1, 0}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}};

static void set_equations(struct fit_equation *e)
{
    struct functional x, y, z;
    int v, q;

    for (v = 0; v < 8; v++)
        for (q = 0; q < C3_COMPS; q++) {
            x = at_end(v & 1, derivative[q][0]);
            y = at_end(v >> 1 & 1, derivative[q][1]);
            z = at_end(v >> 2 & 1, derivative[q][2]);
            product(e++, &x, &y, &z);
        }
}

static void set_profile(struct fit_system *s)
{
    int i, j, n;

    for (i = 0; i < FIT_UNKNOWNS; i++)
        s->first[i] = i;
    for (n = 0; n < FIT_UNKNOWNS; n++) {
        const struct fit_equation *e = &s->equation[n];

        for (i = 0; i < e->terms; i++)
            if (e->index[0] < s->first[e->index[i]])
                s->first[e->index[i]] = e->index[0];
    }
    for (i = 0; i < FIT_UNKNOWNS; i++)
        for (j = s->first[i]; j <= i; j++)
            s->l[i][j] = 0;
}

/* A'A, its lower triangle. */
static void set_normal(struct fit_system *s)
{
    int i, j, n;

    for (n = 0; n < FIT_UNKNOWNS; n++) {
        const struct fit_equation *e = &s->equation[n];

        for (i = 0; i < e->terms; i++)
            for (j = 0; j <= i; j++)
                s->l[e->index[i]][e->index[j]] += e->c[i] * e->c[j];
    }
}

/* A'A = L L', in place. */
static void factor(struct fit_system *s)
{
    int i, j, k;

    for (i = 0; i < FIT_UNKNOWNS; i++)
        for (j = s->first[i]; j <= i; j++) {
            double *row = s->l[i], *other = s->l[j], sum = row[j];

            k = s->first[i] > s->first[j] ? s->first[i] : s->first[j];
            for (; k < j; k++)
                sum -= row[k] * other[k];
            row[j] = j < i ? sum / other[j] : sqrt(sum);
        }
}

/* From now on the equations take data with respect to pixels, and give the right side in units of 1/216. */
static void scale_equations(struct fit_system *s)
{
    int n, i, d;
    double scale;

    for (n = 0; n < FIT_UNKNOWNS; n++) {
        for (scale = FIT_PARTS, d = 0; d < 3; d++)
            if (derivative[n % C3_COMPS][d])
                scale *= s->widths[d];
        for (i = 0; i < s->equation[n].terms; i++)
            s->equation[n].c[i] *= scale;
    }
}

void fit_prepare(struct fit_system *s, const double widths[3])
{
    memcpy(s->widths, widths, sizeof s->widths);
    set_equations(s->equation);
    set_profile(s);
    set_normal(s);
    factor(s);
    scale_equations(s);
}

/* Adding a number whose last bit counts 1 rounds to whole numbers. */
static inline double nearest(double x)
{
    return (x + 0x1.8p52) - 0x1.8p52;
}

/* L L' x = b, where x consists of whole numbers; b becomes x / 216. */
static void substitute(const struct fit_system *s, double b[FIT_UNKNOWNS])
{
    int i, j;
    double x;

    for (i = 0; i < FIT_UNKNOWNS; i++) {
        for (j = s->first[i]; j < i; j++)
            b[i] -= s->l[i][j] * b[j];
        b[i] /= s->l[i][i];
    }
    for (i = FIT_UNKNOWNS - 1; i >= 0; i--) {
        x = nearest(b[i] / s->l[i][i]);
        for (j = s->first[i]; j < i; j++)
            b[j] -= s->l[i][j] * x;
        b[i] = x / FIT_PARTS;
    }
}

void fit_tricubic(const struct fit_system *s, const double *const corner[8], double b[FIT_UNKNOWNS])
{
    int v, q, i;

    for (i = 0; i < FIT_UNKNOWNS; i++)
        b[i] = 0;
    for (v = 0; v < 8; v++)
        for (q = 0; q < C3_COMPS; q++) {
            const struct fit_equation *e = &s->equation[v * C3_COMPS + q];

            for (i = 0; i < e->terms; i++)
                b[e->index[i]] += e->c[i] * corner[v][q];
        }
    substitute(s, b);
}
