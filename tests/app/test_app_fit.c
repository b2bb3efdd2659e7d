/* test_app_fit.c - the trivariate cubic: it interpolates its data, and joins its neighbours smoothly. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "fit.h"
#include "near.h"
#include "subcube.h"

struct data {
    double corner[8][C3_COMPS], widths[3], b[FIT_UNKNOWNS];
};

static double any(unsigned *seed)
{
    return 1000.0 * rand_r(seed) / RAND_MAX - 500.0;
}

static void random_corners(struct data *d, unsigned *seed)
{
    static const double widths[3] = {4, 3, 8};
    memcpy(d->widths, widths, sizeof widths);
    for (int v = 0; v < 8; v++)
        for (int q = 0; q < C3_COMPS; q++)
            d->corner[v][q] = any(seed);
}

static void fit(struct data *d)
{
    const double *corner[8];
    for (int v = 0; v < 8; v++)
        corner[v] = d->corner[v];
    static struct fit_system system;
    fit_prepare(&system, d->widths);
    fit_tricubic(&system, corner, d->b);
}

/* A mixed derivative of F along the axes for which order is 1, by central differences in the subcube's units.
 */
static double derivative(const struct data *d, const double at[3], const int order[3])
{
    const double h = 1e-3;
    double sum = 0, scale = 1;
    for (int axis = 0; axis < 3; axis++)
        scale *= order[axis] ? 2 * h * d->widths[axis] : 1;
    for (int s = 0; s < 8; s++) {
        double p[3], sign = 1;
        int used = 1;
        for (int axis = 0; axis < 3; axis++) {
            int up = s >> axis & 1;
            used &= order[axis] || !up;
            p[axis] = at[axis] + (order[axis] ? (up ? h : -h) : 0);
            sign *= order[axis] && !up ? -1 : 1;
        }
        if (used)
            sum += sign * tricubic_value(d->b, p[0], p[1], p[2]);
    }
    return sum / scale;
}

static void the_fit_interpolates_all_64_data(void **state)
{
    (void)state;
    static const int order[C3_COMPS][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                           {1, 1, 0}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}};
    struct data d;
    unsigned seed = 1;
    for (int i = 0; i < 20; i++) {
        random_corners(&d, &seed);
        fit(&d);
        for (int v = 0; v < 8; v++) {
            double at[3] = {v & 1, v >> 1 & 1, v >> 2};
            assert_near(tricubic_value(d.b, at[0], at[1], at[2]), d.corner[v][F], 1e-7);
            for (int q = 1; q < C3_COMPS; q++)
                assert_near(derivative(&d, at, order[q]), d.corner[v][q], 0.05);
        }
    }
}

static void the_gradient_in_corners_is_the_data(void **state)
{
    (void)state;
    struct data d;
    unsigned seed = 2;
    double b[FIT_UNKNOWNS];
    random_corners(&d, &seed);
    fit(&d);
    memcpy(b, d.b, sizeof b);
    for (int v = 0; v < 8; v++) {
        double at[3] = {v & 1, v >> 1 & 1, v >> 2}, g[3];
        tricubic_gradient(b, at, g);
        for (int axis = 0; axis < 3; axis++)
            assert_near(g[axis] / d.widths[axis], d.corner[v][F_X + axis], 1e-7);
    }
}

/* Two subcubes that share the face at the upper end of `axis` of the first: the data on it are the same, all
 * else differs, even the widths across. */
static void neighbours(struct data *first, struct data *second, int axis, unsigned *seed)
{
    random_corners(first, seed);
    random_corners(second, seed);
    second->widths[axis] = 2.5;
    for (int v = 0; v < 8; v++)
        if (v >> axis & 1)
            memcpy(second->corner[v ^ 1 << axis], first->corner[v], sizeof first->corner[v]);
    fit(first);
    fit(second);
}

static void value_and_gradient_are_continuous_across_faces(void **state)
{
    (void)state;
    unsigned seed = 3;
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < 50; i++) {
            struct data first, second;
            double at[3], from[3], g[3], h[3];
            neighbours(&first, &second, axis, &seed);
            for (int k = 0; k < 3; k++)
                at[k] = from[k] = (double)rand_r(&seed) / RAND_MAX;
            at[axis] = 1;
            from[axis] = 0;
            assert_near(tricubic_value(first.b, at[0], at[1], at[2]),
                        tricubic_value(second.b, from[0], from[1], from[2]), 1e-7);
            tricubic_gradient(first.b, at, g);
            tricubic_gradient(second.b, from, h);
            for (int k = 0; k < 3; k++)
                assert_near(g[k] / first.widths[k], h[k] / second.widths[k], 1e-6);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_fit_interpolates_all_64_data),
        cmocka_unit_test(the_gradient_in_corners_is_the_data),
        cmocka_unit_test(value_and_gradient_are_continuous_across_faces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
