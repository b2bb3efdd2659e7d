/* test_expr.c - expressions: how signs bind, texts, and what is said of those that are wrong. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>

#include "lab/study/expr.h"

static const char *kind_of(void *arg, size_t i)
{
    static const char *const kinds[] = {"none", "all files", "4", NULL};
    (void)arg;
    return kinds[i];
}

static const struct expr_name names[] = {{"nodes", true, NULL, NULL},
                                         {"a", true, NULL, NULL},
                                         {"a-b", true, NULL, NULL},
                                         {"kind", false, kind_of, NULL}};
static const struct expr_value values[] = {{16, NULL}, {3, NULL}, {100, NULL}, {NAN, "all files"}};
enum { NAMES = sizeof names / sizeof *names };

static double value_of(const char *text)
{
    char *why = NULL;
    struct expr *e = expr_read(text, names, NAMES, &why);
    if (!e)
        fail_msg("%s: %s", text, why);
    double value = expr_number(e, values);
    expr_free(e);
    return value;
}

static void assert_is(const char *text, double expected)
{
    double value = value_of(text);
    if (fabs(value - expected) > 1e-12)
        fail_msg("%s is %g, not %g", text, value, expected);
}

static void signs_bind_as_in_mathematics(void **state)
{
    (void)state;
    assert_is("1 + 2 * 3", 7);
    assert_is("(1 + 2) * 3", 9);
    assert_is("10 - 4 - 3", 3);
    assert_is("2 ^ 3 ^ 2", 512);
    assert_is("-2 ^ 2", -4);
    assert_is("2 ^ -1", 0.5);
    assert_is("17 % 5", 2);
    assert_is("1.5e2 / 3", 50);
    assert_is("1 + 1 = 2 && 3 > 2 || 0", 1);
    assert_is("!(1 < 2)", 0);
    assert_is("! 0 && 1", 1);
}

static void names_and_functions(void **state)
{
    (void)state;
    assert_is("nodes / 4", 4);
    assert_is("min(nodes, 8) + max(1, 2)", 10);
    assert_is("log2(nodes) + sqrt(nodes) + floor(2.7) + ceil(2.2) + round(2.5) + abs(-1)", 17);
    assert_is("if(nodes > 8, 1, 2)", 1);
    assert_is("a-b", 100); /* the longest name that is known */
    assert_is("a - nodes", -13);
    assert_is("a-nodes", -13); /* no such name, so that it is a difference */
}

static void texts_are_equal_or_not(void **state)
{
    (void)state;
    assert_is("kind = 'all files'", 1);
    assert_is("kind != none", 1);
    assert_is("none == kind", 0);
    assert_is("kind = 4", 0); /* a text that looks like a number */
}

static void assert_wrong(const char *text, const char *expected)
{
    char *why = NULL;
    struct expr *e = expr_read(text, names, NAMES, &why);
    if (e)
        fail_msg("%s was taken", text);
    assert_string_equal(why, expected);
    free(why);
}

static void mistakes_are_named(void **state)
{
    (void)state;
    assert_wrong("nods / 4", "there is no axis nods; there are: nodes, a, a-b, kind");
    assert_wrong("kind = nobody",
                 "nobody is neither an axis nor a value of kind; its values are: none, all files, 4");
    assert_wrong("kind < 4", "kind is no number or axis of numbers: only = and != are allowed");
    assert_wrong("kind = nodes", "kind is no number or axis of numbers: only = and != are allowed");
    assert_wrong("nodes = 'x'", "there is no axis x; there are: nodes, a, a-b, kind");
    assert_wrong("kind", "kind is no number or axis of numbers: only = and != are allowed");
    assert_wrong("1 +", "something is missing at the end of \"1 +\"");
    assert_wrong("1 2", "\"2\" is one too many in \"1 2\"");
    assert_wrong("(1", ") is missing at \"\"");
    assert_wrong("'x", "' is missing after x");
    assert_wrong("min(1)", "min needs 2 values, with commas between");
    assert_wrong("1 < 2 < 3", "compares twice at \"3\": join comparisons by &&");
    assert_wrong("#", "\"#\" is neither a number, a name nor '('");
    assert_wrong("", "something is missing at the end of \"\"");
}

static void depth_and_length_have_limits(void **state)
{
    char deep[1024], *why = NULL;
    (void)state;
    for (size_t i = 0; i < sizeof deep - 1; i++)
        deep[i] = '(';
    deep[sizeof deep - 1] = '\0';
    assert_null(expr_read(deep, names, NAMES, &why));
    free(why);
    why = NULL;
    for (size_t i = 0; i + 1 < sizeof deep; i += 2) {
        deep[i] = '1';
        deep[i + 1] = '+';
    }
    deep[sizeof deep - 2] = '\0';
    assert_null(expr_read(deep, names, NAMES, &why));
    free(why);
}

static void what_is_no_number_says_so(void **state)
{
    (void)state;
    assert_false(isfinite(value_of("1 / 0")));
    assert_false(isfinite(value_of("sqrt(-1)")));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(signs_bind_as_in_mathematics), cmocka_unit_test(names_and_functions),
        cmocka_unit_test(texts_are_equal_or_not),       cmocka_unit_test(mistakes_are_named),
        cmocka_unit_test(depth_and_length_have_limits), cmocka_unit_test(what_is_no_number_says_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
