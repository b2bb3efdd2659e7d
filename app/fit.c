/* fit.c - least squares fit of a trivariate cubic to C3 data.
 *
 * 8 corners with 8 numbers each give 64 equations A b = d in the 64 coefficients. We form the normal equations
 * A'A b = A'd and solve them by Cholesky's method. In the natural order of the unknowns a coefficient meets only
 * coefficients whose indices differ by at most one in each direction, so A'A has half bandwidth 16 + 4 + 1 = 21.
 *
 * The value and the normal derivative of F on a face depend on the data of the face's corners only: neighbouring
 * subcubes join with C1 continuity.
 */
#include <math.h>
#include <string.h>
#include "fit.h"

#define BAND 21

/* Lower triangle by columns: a[j][d] is the element in row j + d, column j. */
struct normal {
    double a[FIT_UNKNOWNS][BAND + 1];
    double rhs[FIT_UNKNOWNS];
};

/* One univariate functional on cubic Bernstein coefficients: value or derivative at one end of an edge. */
struct functional {
    int terms, first;
    double c[2];
};

static struct functional at_end(int end, int derivative, double width)
{
    struct functional l;

    if (derivative) {
        l.terms = 2;
        l.first = end ? 2 : 0;
        l.c[0] = -3.0 / width;
        l.c[1] = 3.0 / width;
    } else {
        l.terms = 1;
        l.first = end ? 3 : 0;
        l.c[0] = 1.0;
        l.c[1] = 0.0;
    }
    return l;
}

/* One equation: the product of three functionals; up to 8 coefficients, in rising order of their indices. */
struct equation {
    int terms;
    int index[8];
    double c[8];
};

static void product(struct equation *e, const struct functional *x, const struct functional *y,
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

static void add_equation(struct normal *n, const struct equation *e, double d)
{
    int i, j;

    for (j = 0; j < e->terms; j++) {
        double *column = n->a[e->index[j]];

        for (i = j; i < e->terms; i++)
            column[e->index[i] - e->index[j]] += e->c[i] * e->c[j];
        n->rhs[e->index[j]] += e->c[j] * d;
    }
}

static void build(struct normal *n, const double *const corner[8], const double widths[3])
{
    /* for each number of the C3 data: is it a derivative along x, y, z? */
    static const int derivative[C3_COMPS][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                                {1, 1, 0}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}};
    struct functional x, y, z;
    struct equation e;
    int v, q;

    memset(n, 0, sizeof *n);
    for (v = 0; v < 8; v++)
        for (q = 0; q < C3_COMPS; q++) {
            x = at_end(v & 1, derivative[q][0], widths[0]);
            y = at_end(v >> 1 & 1, derivative[q][1], widths[1]);
            z = at_end(v >> 2 & 1, derivative[q][2], widths[2]);
            product(&e, &x, &y, &z);
            add_equation(n, &e, corner[v][q]);
        }
}

static int below(int column)
{
    return column + BAND < FIT_UNKNOWNS ? BAND : FIT_UNKNOWNS - 1 - column;
}

/* A = L L', in place. */
static void factor(double a[FIT_UNKNOWNS][BAND + 1])
{
    int j, i, k;

    for (j = 0; j < FIT_UNKNOWNS; j++) {
        double *pivot = a[j], inverse;
        int m = below(j);

        pivot[0] = sqrt(pivot[0]);
        inverse = 1.0 / pivot[0];
        for (i = 1; i <= m; i++)
            pivot[i] *= inverse;
        for (k = 1; k <= m; k++) {
            double *column = a[j + k], factor_k = pivot[k];

            if (factor_k == 0)
                continue; /* much of the band is empty, and stays so */
            for (i = k; i <= m; i++)
                column[i - k] -= pivot[i] * factor_k;
        }
    }
}

/* L L' x = b, b becomes x. */
static void substitute(double a[FIT_UNKNOWNS][BAND + 1], double b[FIT_UNKNOWNS])
{
    int j, i, m;

    for (j = 0; j < FIT_UNKNOWNS; j++) {
        b[j] /= a[j][0];
        for (i = 1, m = below(j); i <= m; i++)
            b[j + i] -= a[j][i] * b[j];
    }
    for (j = FIT_UNKNOWNS - 1; j >= 0; j--) {
        for (i = 1, m = below(j); i <= m; i++)
            b[j] -= a[j][i] * b[j + i];
        b[j] /= a[j][0];
    }
}

void fit_tricubic(const double *const corner[8], const double widths[3], double b[FIT_UNKNOWNS])
{
    struct normal n;

    build(&n, corner, widths);
    factor(n.a);
    substitute(n.a, n.rhs);
    memcpy(b, n.rhs, sizeof n.rhs);
}
