/* test_app_fit.c - the trivariate cubic: it interpolates its data, and joins its neighbours smoothly. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "fit.h"
#include "near.h"
#include "subcube.h"

struct data {
    double corner[8][C3_COMPS], widths[3], b[FIT_UNKNOWNS];
};

/* A number of C3 data is a whole number divided by 2 for each derivative, and one along z by the distance of
 * slices. */
static double any(unsigned *seed, int number, double dz)
{
    static const double divisor[C3_COMPS] = {1, 2, 2, 2, 4, 4, 4, 8};
    double whole = rand_r(seed) % 1000 - 500.0;
    bool along_z = number == F_Z || number == F_YZ || number == F_XZ || number == F_XYZ;
    return whole / divisor[number] / (along_z ? dz : 1);
}

static void random_corners_of(struct data *d, const double widths[3], unsigned *seed)
{
    memcpy(d->widths, widths, sizeof d->widths);
    for (int v = 0; v < 8; v++)
        for (int q = 0; q < C3_COMPS; q++)
            d->corner[v][q] = any(seed, q, widths[2]);
}

static void random_corners(struct data *d, unsigned *seed)
{
    static const double widths[3] = {4, 3, 8};
    random_corners_of(d, widths, seed);
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
static void neighbours(struct data *first, struct data *second, const double widths[3], int axis,
                       unsigned *seed)
{
    random_corners_of(first, widths, seed);
    random_corners_of(second, widths, seed);
    if (axis < 2)
        second->widths[axis] = 2;
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
            static const double widths[3] = {4, 3, 8};
            neighbours(&first, &second, widths, axis, &seed);
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

/* Coefficient n, 0 to 15, of the layer of coefficients `at` (0 to 3) along an axis. */
static double coefficient(const struct data *d, int axis, int at, int n)
{
    static const int step[3] = {16, 4, 1};
    int i = n / 4, j = n % 4;
    return d->b[at * step[axis] + i * step[axis == 0] + j * step[axis == 2 ? 1 : 2]];
}

static void neighbours_have_the_same_coefficients_on_their_face_to_the_bit(void **state)
{
    (void)state;
    static const double sides[][3] = {{4, 4, 8}, {4, 3, 0.001}, {4, 4, 1.7}, {1, 1, 300.1}, {64, 64, 0.3}};
    unsigned seed = 4;
    for (size_t s = 0; s < sizeof sides / sizeof *sides; s++)
        for (int axis = 0; axis < 3; axis++)
            for (int i = 0; i < 50; i++) {
                struct data first, second;
                neighbours(&first, &second, sides[s], axis, &seed);
                double ratio = second.widths[axis] / first.widths[axis];
                for (int n = 0; n < 16; n++) {
                    double a = coefficient(&first, axis, 3, n), b = coefficient(&second, axis, 0, n);
                    double up = a - coefficient(&first, axis, 2, n),
                           on = coefficient(&second, axis, 1, n) - b;
                    assert_true(a == b);
                    assert_near(up * ratio, on, 1e-12 * (fabs(a) + fabs(up) + fabs(on)));
                }
            }
}

static void whole_levels_without_slope_stay_whole(void **state)
{
    (void)state;
    struct data d = {.widths = {4, 4, 0.7}};
    for (int v = 0; v < 8; v++)
        d.corner[v][F] = 77;
    fit(&d);
    for (int i = 0; i < FIT_UNKNOWNS; i++)
        assert_true(d.b[i] == 77);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_fit_interpolates_all_64_data),
        cmocka_unit_test(the_gradient_in_corners_is_the_data),
        cmocka_unit_test(value_and_gradient_are_continuous_across_faces),
        cmocka_unit_test(neighbours_have_the_same_coefficients_on_their_face_to_the_bit),
        cmocka_unit_test(whole_levels_without_slope_stay_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
