/* test_fit.c - least squares without derivatives, and which numbers the residuals determine. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>

#include "study/fit_least.h"

/* Two curves of two numbers, as times are: least at 0.3 and 0.8. */
static bool curves(void *arg, const double x[], double r[])
{
    unsigned *calls = arg;
    ++*calls;
    for (int i = 0; i < 4; i++)
        r[i] = (x[0] - 0.3) * (i + 1) + (x[1] * x[1] - 0.64) * (4 - i) * (4 - i);
    return true;
}

static void the_least_is_found(void **state)
{
    (void)state;
    unsigned calls = 0;
    struct fit_problem p = {2, 4, curves, &calls};
    double x[] = {0.9, 0.1};
    assert_true(fit_least(&p, x, 200));
    assert_true(fabs(x[0] - 0.3) < 1e-4 && fabs(x[1] - 0.8) < 1e-4);
    assert_true(calls < 100);
    assert_non_null(fit_least_method(2));
}

static bool steps(void *arg, const double x[], double r[])
{
    (void)arg;
    r[0] = floor(x[0] * 1000) / 1000 - 0.123;
    return true;
}

static void one_number_and_steps_will_do(void **state)
{
    (void)state;
    struct fit_problem p = {1, 1, steps, NULL};
    double x[] = {0.5};
    assert_true(fit_least(&p, x, 200));
    assert_true(fabs(x[0] - 0.123) <= 0.0015);
}

static bool outside(void *arg, const double x[], double r[])
{
    (void)arg;
    r[0] = x[0] - 2;
    r[1] = x[1] + 1;
    return x[0] >= 0 && x[0] <= 1 && x[1] >= 0 && x[1] <= 1;
}

static void ranges_are_kept(void **state)
{
    (void)state;
    struct fit_problem p = {2, 2, outside, NULL};
    double x[] = {0.5, 0.5}, slope[4];
    assert_true(fit_least(&p, x, 100));
    assert_true(x[0] > 0.999 && x[1] < 0.001);
    assert_true(fit_slopes(&p, x, 0.01, slope)); /* at the ends too */
    assert_true(fabs(slope[0] - 1) < 1e-9 && slope[1] == 0 && slope[2] == 0 && fabs(slope[3] - 1) < 1e-9);
}

static bool third_fails(void *arg, const double x[], double r[])
{
    unsigned *calls = arg;
    r[0] = x[0];
    return ++*calls < 3;
}

static void what_cannot_go_on_is_not_asked_again(void **state)
{
    (void)state;
    unsigned calls = 0;
    struct fit_problem p = {2, 1, third_fails, &calls};
    double x[] = {0.5, 0.5};
    assert_false(fit_least(&p, x, 100));
    assert_int_equal(calls, 3);
}

static void errors_are_the_scatter_over_the_slope(void **state)
{
    (void)state;
    static const double slope[] = {2, 0, 0, 4};
    struct fit_number of[2];
    fit_determine(slope, 2, 2, 0.1, of);
    assert_int_equal(of[0].standing, FIT_DETERMINED);
    assert_int_equal(of[1].standing, FIT_DETERMINED);
    assert_true(fabs(of[0].error - 0.05) < 1e-12 && fabs(of[1].error - 0.025) < 1e-12);
}

static void a_number_without_influence_is_found(void **state)
{
    (void)state;
    static const double slope[] = {2, 0, 1, 0, 3, 0};
    struct fit_number of[2];
    fit_determine(slope, 3, 2, 0.1, of);
    assert_int_equal(of[0].standing, FIT_DETERMINED);
    assert_int_equal(of[1].standing, FIT_NO_INFLUENCE);
    assert_true(isinf(of[1].error));
}

static void numbers_that_do_the_same_are_found_together(void **state)
{
    (void)state;
    static const double slope[] = {2, 4, 0, 1, 2, 0, 0, 0, 1}; /* the second does twice what the first does */
    struct fit_number of[3];
    fit_determine(slope, 3, 3, 0.01, of);
    assert_int_equal(of[0].standing, FIT_TOGETHER);
    assert_int_equal(of[1].standing, FIT_TOGETHER);
    assert_int_equal(of[2].standing, FIT_DETERMINED);
    assert_true(of[0].with[1] && of[1].with[0] && !of[0].with[2] && !of[2].with[0]);
}

static void fewer_residuals_than_numbers_leave_them_open(void **state)
{
    (void)state;
    static const double slope[] = {1, 1};
    struct fit_number of[2];
    fit_determine(slope, 1, 2, 0.01, of);
    assert_int_equal(of[0].standing, FIT_TOGETHER);
    assert_int_equal(of[1].standing, FIT_TOGETHER);
}

static void scatter_may_leave_a_number_open(void **state)
{
    (void)state;
    static const double slope[] = {0.1, 0, 0, 5};
    struct fit_number of[2];
    fit_determine(slope, 2, 2, 0.1, of);
    assert_int_equal(of[0].standing, FIT_OPEN);
    assert_int_equal(of[1].standing, FIT_DETERMINED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_least_is_found),
        cmocka_unit_test(one_number_and_steps_will_do),
        cmocka_unit_test(ranges_are_kept),
        cmocka_unit_test(what_cannot_go_on_is_not_asked_again),
        cmocka_unit_test(errors_are_the_scatter_over_the_slope),
        cmocka_unit_test(a_number_without_influence_is_found),
        cmocka_unit_test(numbers_that_do_the_same_are_found_together),
        cmocka_unit_test(fewer_residuals_than_numbers_leave_them_open),
        cmocka_unit_test(scatter_may_leave_a_number_open),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
