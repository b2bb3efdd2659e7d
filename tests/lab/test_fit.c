/* test_fit.c - least squares without derivatives, and which numbers the residuals determine. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "lab/fit/fit_parts.h"

/* Residuals of two numbers, least at 0.3 and 0.8. */
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
    double x[] = {0.5, 0.5}, here[2], slope[4];
    assert_true(fit_least(&p, x, 100));
    assert_true(x[0] > 0.999 && x[1] < 0.001);
    assert_true(outside(NULL, x, here));
    assert_true(fit_slopes(&p, x, here, 0.01, slope)); /* at the ends of the range, too */
    assert_true(fabs(slope[0] - 1) < 1e-9 && slope[1] == 0 && slope[2] == 0 && fabs(slope[3] - 1) < 1e-9);
}

/* As curves(), but runs fail where a number is above its limit: some beside the least, some at it. */
static const double *limits;

static bool limited(void *arg, const double x[], double r[])
{
    curves(arg, x, r);
    for (int k = 0; k < 2; k++)
        if (x[k] > limits[k])
            r[k] = NAN;
    return true;
}

static void the_best_has_not_failed(void **state)
{
    (void)state;
    static const double BESIDE[] = {0.301, 1}, AT[] = {0.2, 1};
    unsigned calls = 0;
    struct fit_problem p = {2, 4, limited, &calls};
    double x[] = {0.1, 0.1};
    limits = BESIDE;
    assert_true(fit_least(&p, x, 200));
    assert_true(fabs(x[0] - 0.3) < 1e-4 && fabs(x[1] - 0.8) < 1e-4);
    limits = AT;
    x[0] = 0.1, x[1] = 0.1;
    assert_true(fit_least(&p, x, 200));
    assert_true(x[0] > 0.195 && x[0] <= 0.2 && fabs(x[1] - 0.8) < 0.02);
}

/* Number 0 fails above, number 1 on both sides of x. */
static bool beside(void *arg, const double x[], double r[])
{
    (void)arg;
    r[0] = x[0] > 0.5 ? NAN : 3 * x[0];
    r[1] = x[1] == 0.5 ? x[0] : NAN;
    return true;
}

static void slopes_are_taken_where_runs_have_not_failed(void **state)
{
    (void)state;
    struct fit_problem p = {2, 2, beside, NULL};
    double x[] = {0.5, 0.5}, here[2], slope[4];
    assert_true(beside(NULL, x, here));
    assert_true(fit_slopes(&p, x, here, 0.01, slope));
    assert_true(fabs(slope[0] - 3) < 1e-9 && slope[1] == 0);
    assert_true(fabs(slope[2] - 1) < 1e-9 && isnan(slope[3]));
}

static void what_has_failed_determines_nothing(void **state)
{
    (void)state;
    static const double slope[] = {1, NAN, 2, 0};
    struct fit_number of[2];
    fit_determine(slope, 2, 2, 0.1, of);
    assert_int_equal(of[0].standing, FIT_DETERMINED);
    assert_true(fabs(of[0].error - 0.05) < 1e-12);
    assert_int_equal(of[1].standing, FIT_OPEN);
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
    static const double slope[] = {2, 4, 0, 1, 2,
                                   0, 0, 0, 1}; /* the second number has twice the influence of the first */
    struct fit_number of[3];
    fit_determine(slope, 3, 3, 0.01, of);
    assert_int_equal(of[0].standing, FIT_COMBINED);
    assert_int_equal(of[1].standing, FIT_COMBINED);
    assert_int_equal(of[2].standing, FIT_DETERMINED);
    assert_true(of[0].with[1] && of[1].with[0] && !of[0].with[2] && !of[2].with[0]);
}

static void fewer_residuals_than_numbers_leave_them_open(void **state)
{
    (void)state;
    static const double slope[] = {1, 1};
    struct fit_number of[2];
    fit_determine(slope, 1, 2, 0.01, of);
    assert_int_equal(of[0].standing, FIT_COMBINED);
    assert_int_equal(of[1].standing, FIT_COMBINED);
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

/* --- tables of measurements --- */

struct rows {
    size_t count;
    json_t *list;
    char at[64];
};

static bool keep_row(void *arg, const json_t *cells, const char *at, char **error)
{
    struct rows *rows = arg;
    (void)error;
    json_array_append(rows->list, (json_t *)cells);
    snprintf(rows->at, sizeof rows->at, "%s", strrchr(at, ':'));
    return true;
}

/* The rows of a table as JSON, or the error without the file's name; malloc'd. */
static char *rows_of(const char *table)
{
    char path[] = "/tmp/test_fit.XXXXXX", *error = NULL;
    int fd = mkstemp(path);
    assert_int_equal(write(fd, table, strlen(table)), strlen(table));
    close(fd);
    struct rows rows = {.list = json_array()};
    bool good = fit_table(path, keep_row, &rows, &error);
    char *text = good ? json_dumps(rows.list, JSON_COMPACT | JSON_SORT_KEYS) : strdup(error + strlen(path));
    free(error);
    json_decref(rows.list);
    unlink(path);
    return text;
}

static void assert_rows(const char *table, const char *expected)
{
    char *rows = rows_of(table);
    assert_string_equal(rows, expected);
    free(rows);
}

static void a_table_has_names_and_rows(void **state)
{
    (void)state;
    assert_rows("nodes,total_s\n2,1.50\n", "[{\"nodes\":\"2\",\"total_s\":\"1.50\"}]");
    assert_rows("# measured\n\n a , b\r\n 1 ,\"x, \"\"y\"\"\"\r\n", "[{\"a\":\"1\",\"b\":\"x, \\\"y\\\"\"}]");
    assert_rows("a,b,c\n,-,3\n", "[{\"c\":\"3\"}]"); /* empty and - are not measured */
    assert_rows("a,b\n\"1\",2", "[{\"a\":\"1\",\"b\":\"2\"}]");
    assert_rows("\xef\xbb\xbf"
                "a,b\n1,2\n",
                "[{\"a\":\"1\",\"b\":\"2\"}]"); /* of a spreadsheet */
    assert_rows("", "[]");
}

static void a_wrong_table_is_told_by_line(void **state)
{
    (void)state;
    assert_rows("a,b\n1,2\n1\n", ":3: 1 cells, and 2 names in the first line");
    assert_rows("a,b\n1,2,3\n", ":2: 3 cells, and 2 names in the first line");
    assert_rows("a,,b\n", ":1: column 2: a name is needed, and each only once");
    assert_rows("a,b\n1,gr\xfcn\n", ":2: a byte that is not UTF-8 text");
    assert_rows("a,b,a\n", ":1: column 3: a name is needed, and each only once");
}

static void a_parameter_goes_evenly_or_by_its_logarithm(void **state)
{
    (void)state;
    struct fit_parameter even = {.from = 10, .to = 30}, log = {.from = 1, .to = 100, .logarithmic = true};
    char text[32];
    assert_true(fit_value(&even, 0.25) == 15 && fabs(fit_value(&log, 0.5) - 10) < 1e-12);
    assert_true(fit_position(&even, 15) == 0.25 && fabs(fit_position(&log, 10) - 0.5) < 1e-12);
    fit_text(&even, 1.0 / 3, text);
    assert_string_equal(text, "16.6667");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_least_is_found),
        cmocka_unit_test(one_number_and_steps_will_do),
        cmocka_unit_test(ranges_are_kept),
        cmocka_unit_test(the_best_has_not_failed),
        cmocka_unit_test(slopes_are_taken_where_runs_have_not_failed),
        cmocka_unit_test(what_has_failed_determines_nothing),
        cmocka_unit_test(what_cannot_go_on_is_not_asked_again),
        cmocka_unit_test(errors_are_the_scatter_over_the_slope),
        cmocka_unit_test(a_number_without_influence_is_found),
        cmocka_unit_test(numbers_that_do_the_same_are_found_together),
        cmocka_unit_test(fewer_residuals_than_numbers_leave_them_open),
        cmocka_unit_test(scatter_may_leave_a_number_open),
        cmocka_unit_test(a_table_has_names_and_rows),
        cmocka_unit_test(a_wrong_table_is_told_by_line),
        cmocka_unit_test(a_parameter_goes_evenly_or_by_its_logarithm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
