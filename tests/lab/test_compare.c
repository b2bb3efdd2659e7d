/* test_compare.c - comparisons with a baseline: what is worse and by how much, where time moved, JUnit
 * XML. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "lab/check/baseline.h"
#include "lab/check/baseline_point.h"
#include "lab/check/compare_print.h"
#include "lab/check/junit.h"

static json_t *json(const char *text)
{
    json_error_t why;
    json_t *j = json_loads(text, JSON_DISABLE_EOF_CHECK, &why);
    if (!j)
        fail_msg("%s in %s", why.text, text);
    return j;
}

/* The baseline's form of a run's figures. */
static json_t *point(const char *figures)
{
    json_t *flat = json(figures), *axes = json("{\"nodes\": [], \"group\": []}"),
           *p = baseline_point(flat, axes);
    json_decref(flat);
    json_decref(axes);
    return p;
}

static struct compare_point *compared(const char *before, const char *after, const char *tolerance,
                                      bool exact)
{
    struct compare_rules rules = {.exact = exact};
    char *why = NULL;
    assert_true(!tolerance || compare_rules_add(&rules, tolerance, &why));
    json_t *old = before ? point(before) : NULL, *new = after ? point(after) : NULL;
    struct compare_point *p = compare_point("s", "nodes 2", old, new, NULL, &rules);
    json_decref(old);
    json_decref(new);
    compare_rules_clear(&rules);
    return p;
}

static enum compare_verdict verdict(const char *before, const char *after, const char *tolerance)
{
    struct compare_point *p = compared(before, after, tolerance, false);
    enum compare_verdict v = p->verdict;
    compare_free(p);
    return v;
}

static void the_last_digit_counts(void **state)
{
    (void)state;
    const char *one = "{\"total_s\": 142.915240000001}";
    assert_int_equal(verdict(one, one, NULL), COMPARE_SAME);
    assert_int_equal(verdict(one, "{\"total_s\": 142.915240000002}", NULL), COMPARE_WORSE);
    assert_int_equal(verdict(one, "{\"total_s\": 142.915240000000}", NULL), COMPARE_BETTER);
}

static void more_is_worse_of_costs_and_less_of_speeds(void **state)
{
    (void)state;
    static const char *const costs[] = {"total_s", "virtual_time_s", "messages", "bytes",
                                        "memory_peak_bytes"};
    for (size_t i = 0; i < 7; i++) {
        char one[64], two[64];
        const char *name = i < 5 ? costs[i] : i == 5 ? "speedup" : "speed_per_node";
        snprintf(one, sizeof one, "{\"%s\": 1}", name);
        snprintf(two, sizeof two, "{\"%s\": 2}", name);
        assert_int_equal(verdict(one, two, NULL), i < 5 ? COMPARE_WORSE : COMPARE_BETTER);
        assert_int_equal(verdict(two, one, NULL), i < 5 ? COMPARE_BETTER : COMPARE_WORSE);
    }
}

static void other_figures_decide_only_if_a_tolerance_names_them(void **state)
{
    (void)state;
    const char *a = "{\"polygons\": 100, \"digest\": \"a\"}", *b = "{\"polygons\": 99, \"digest\": \"b\"}";
    assert_int_equal(verdict(a, b, NULL), COMPARE_TOLD);
    assert_int_equal(verdict(a, b, "5%"), COMPARE_TOLD);
    assert_int_equal(verdict(a, b, "polygons=0"), COMPARE_WORSE);
    assert_int_equal(verdict(a, b, "polygons=1"), COMPARE_TOLD);
    assert_int_equal(verdict(a, b, "digest=0"), COMPARE_WORSE);
    struct compare_point *p = compared(a, b, NULL, true);
    assert_int_equal(p->verdict, COMPARE_WORSE);
    assert_int_equal(p->figure_count, 2);
    compare_free(p);
}

static void a_faster_base_makes_no_speed_worse(void **state)
{
    (void)state;
    const char *a = "{\"virtual_time_s\": 2, \"speed_per_node\": 0.9}";
    assert_int_equal(verdict(a, "{\"virtual_time_s\": 2, \"speed_per_node\": 0.8}", NULL), COMPARE_TOLD);
    assert_int_equal(verdict(a, "{\"virtual_time_s\": 2, \"speed_per_node\": 0.95}", NULL), COMPARE_TOLD);
    assert_int_equal(verdict(a, "{\"virtual_time_s\": 2, \"speed_per_node\": 0.8}", "speed_per_node=1%"),
                     COMPARE_WORSE);
    assert_int_equal(verdict(a, "{\"virtual_time_s\": 2.1, \"speed_per_node\": 0.8}", "10%"), COMPARE_WORSE);
}

static void a_tolerance_is_relative_or_in_the_figures_unit(void **state)
{
    (void)state;
    const char *a = "{\"total_s\": 200, \"messages\": 100}", *b = "{\"total_s\": 202, \"messages\": 103}";
    assert_int_equal(verdict(a, b, "3%"), COMPARE_TOLD);
    assert_int_equal(verdict(a, b, "2%"), COMPARE_WORSE);
    assert_int_equal(verdict(a, b, "total_s=1%,messages=3"), COMPARE_TOLD);
    assert_int_equal(verdict(a, b, "total_s=1%,messages=2.9"), COMPARE_WORSE);
    assert_int_equal(verdict(a, b, "3%,messages=0"),
                     COMPARE_WORSE); /* a figure's own tolerance replaces the general one */
    assert_int_equal(verdict(a, b, "messages=3"),
                     COMPARE_WORSE); /* without a general tolerance the others have none */
    assert_int_equal(verdict(b, a, "0.5%"), COMPARE_BETTER);
}

static void wrong_tolerances_are_named(void **state)
{
    (void)state;
    static const char *const wrong[] = {"",         "x",          "-1%", "1%%", "=1%",
                                        "total_s=", "total_s=1s", "5",   "nan", "1%,"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct compare_rules rules = {0};
        char *why = NULL;
        assert_false(compare_rules_add(&rules, wrong[i], &why));
        assert_non_null(strstr(why, "'"));
        free(why);
        compare_rules_clear(&rules);
    }
}

static void a_tolerance_for_no_figure_is_found(void **state)
{
    (void)state;
    struct compare_rules rules = {0};
    char *why = NULL;
    assert_true(compare_rules_add(&rules, "1%,a=1,b=2", &why));
    json_t *p = json("{\"figures\": {\"a\": 1}}");
    assert_string_equal(compare_rules_unused(&rules, json_object_get(p, "figures")), "b");
    json_decref(p);
    compare_rules_clear(&rules);
}

static void points_come_and_go(void **state)
{
    (void)state;
    assert_int_equal(verdict(NULL, "{\"a\": 1}", NULL), COMPARE_NEW);
    assert_int_equal(verdict("{\"a\": 1}", NULL, NULL), COMPARE_MISSING);
    assert_true(compare_is_failure(COMPARE_MISSING) && compare_is_failure(COMPARE_FAILED));
    assert_false(compare_is_failure(COMPARE_NEW) || compare_is_failure(COMPARE_BETTER));
    assert_int_equal(verdict("{\"total_s\": 1, \"a\": 1}", "{\"a\": 1}", NULL),
                     COMPARE_WORSE); /* a named figure is no longer only told */
}

static void where_files_are_and_wall_times_are_left_out(void **state)
{
    (void)state;
    json_t *p = point(
               "{\"nodes\": 2, \"group\": 1, \"program\": \"/a/b\", \"wall_time_s\": 0.1, \"failure\": null, "
               "\"outcome\": \"ended\", \"settings\": [\"a=1\"], \"each\": [1, 2.5], \"bytes\": 3}"),
           *expected = json("{\"figures\": {\"each\": [1, 2.5], \"bytes\": 3}}");
    assert_true(json_equal(p, expected));
    json_decref(p);
    json_decref(expected);
}

static void a_point_is_called_by_its_axes(void **state)
{
    (void)state;
    json_t *axes = json("{\"nodes\": [], \"share\": [], \"kind\": []}"), *none = json("{}"),
           *p = json("{\"nodes\": 16, \"share\": 0.5, \"kind\": \"all\"}");
    char *name = baseline_name(p, axes), *only = baseline_name(p, none);
    assert_string_equal(name, "nodes 16, share 0.5, kind all");
    assert_string_equal(only, "the run");
    free(name);
    free(only);
    json_decref(p);
    json_decref(axes);
    json_decref(none);
}

/* As compare_print() prints it: malloc'd. */
static char *printed(const struct compare_point *p)
{
    char *text = NULL;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    compare_print(p, f);
    fclose(f);
    return text;
}

#define PROFILE(mix, copies, idle)                                                                           \
    "{\"total_s\": " mix ", \"profile\": {\"functions\": ["                                                  \
    "{\"file\": \"x/a.c\", \"function\": \"mix\", \"others\": {\"seconds\": " mix "}}, "                     \
    "{\"file\": \"/y/a.c\", \"function\": \"pack\", \"called\": \"memcpy\", "                                \
    "\"others\": {\"seconds\": " copies "}}], "                                                              \
    "\"classes\": {\"others\": {\"nodes\": 7, \"beside_s\": 0.0, \"rest_s\": 0.25, "                         \
    "\"tasks\": {\"copying_s\": 0.5}, "                                                                      \
    "\"waits\": [{\"call\": \"crecv\", \"idle_s\": " idle "}]}}}}"

static void time_that_moved_is_told_by_function_first(void **state)
{
    (void)state;
    struct compare_point *p =
        compared(PROFILE("1.0", "2.0", "1.0"), PROFILE("1.5", "4.0", "9.0"), NULL, false);
    assert_int_equal(p->verdict, COMPARE_WORSE);
    assert_int_equal(p->move_count, 3);
    assert_string_equal(p->moves[0].name, "memcpy called by pack (a.c)");
    assert_string_equal(p->moves[0].class, "others");
    assert_true(p->moves[0].after_s - p->moves[0].before_s == 2);
    assert_string_equal(p->moves[1].name, "mix (a.c)");
    assert_int_equal(p->moves[2].kind, COMPARE_IDLE);
    char *text = printed(p);
    assert_string_equal(text, "WORSE   s: nodes 2\n"
                              "  worse   total_s              1.0 -> 1.5 (+50.00 %, +0.5)\n"
                              "  where the time of all nodes moved:\n"
                              "    nodes     memcpy called by pack (a.c) +2.000000 s (+100.0 %)\n"
                              "    nodes     mix (a.c) +0.500000 s (+50.0 %)\n"
                              "    nodes     idle: crecv +8.000000 s (+800.0 %)\n"
                              "    nodes     in all: functions +2.500000 s, idle +8.000000 s\n");
    free(text);
    compare_free(p);
}

/* Of microseconds too; what only rounding left of a sum is nothing. */
static void small_moves_have_four_digits(void **state)
{
    (void)state;
    struct compare_point *p = compared(PROFILE("0.000001", "0.3", "0.5"),
                                       PROFILE("0.00000131", "0.3000000005", "0.4999996895"), NULL, false);
    char *text = printed(p);
    assert_non_null(strstr(text, "mix (a.c) +0.0000003100 s (+31.0 %)\n"
                                 "    nodes     memcpy called by pack (a.c) +0.0000000005 s (+0.0 %)\n"
                                 "    nodes     idle: crecv -0.0000003105 s (-0.0 %)\n"
                                 "    nodes     in all: functions +0.0000003105 s, idle -0.0000003105 s\n"));
    free(text);
    compare_free(p);
    p = compared(PROFILE("1.0", "0.3", "0.1"), PROFILE("1.1", "0.2", "0.1"), NULL, false);
    text = printed(p);
    assert_non_null(strstr(text, "    nodes     in all: nothing\n")); /* 0.1 - 0.1 is -1e-17 or so */
    free(text);
    compare_free(p);
}

static void changes_stand_in_one_column(void **state)
{
    (void)state;
    struct compare_point *p = compared("{\"total_s\": 1, \"slave_idle_spread_pct\": 2}",
                                       "{\"total_s\": 2, \"slave_idle_spread_pct\": 3}", NULL, false);
    char *text = printed(p);
    assert_string_equal(text, "WORSE   s: nodes 2\n"
                              "  worse   total_s               1 -> 2 (+100.00 %, +1)\n"
                              "          slave_idle_spread_pct 2 -> 3 (+50.00 %, +1)\n");
    free(text);
    compare_free(p);
}

static void without_a_profile_it_is_told_by_class(void **state)
{
    (void)state;
#define CLASSES(busy, wait)                                                                                  \
    "{\"handlers.nodes\": 1, \"handlers.busy_s\": 1, \"others.nodes\": 3, \"others.busy_s\": " busy          \
    ", \"others.waits.message_s\": " wait ", \"messages\": " busy "}"
    struct compare_point *p = compared(CLASSES("1", "2"), CLASSES("2", "4"), NULL, false);
    assert_int_equal(p->move_count, 2);
    assert_string_equal(p->moves[0].name, "all of the program");
    assert_true(p->moves[0].before_s == 3 && p->moves[0].after_s == 6);
    assert_string_equal(p->moves[1].name, "message");
    assert_int_equal(p->figure_count, 1);
    compare_free(p);
}

static void a_baseline_is_the_same_when_read_again(void **state)
{
    (void)state;
    char path[] = "/tmp/test_compare.XXXXXX", *error = NULL;
    close(mkstemp(path));
    json_t *b = baseline_new();
    json_object_set_new(baseline_study(b, "s"), "p",
                        point(PROFILE("0.1", "0.30000000000000004", "123.456789012345")));
    assert_true(baseline_write(b, path, &error));
    json_t *again = baseline_read(path, &error);
    assert_true(json_equal(b, again));
    assert_non_null(json_object_get(baseline_find(again, "s"), "p"));
    assert_null(baseline_find(again, "t"));
    json_decref(b);
    json_decref(again);
    unlink(path);
}

static void what_is_no_baseline_is_told(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        {"{\n\"format\" \"x\"}", ":2: "},
        {"{\"format\": \"touchstone baseline 9\"}", "touchstone baseline 1"},
        {"{\"format\": \"touchstone baseline 1\"}", "no \"studies\""},
        {"{\"format\": \"touchstone baseline 1\", \"studies\": {\"s\": {\"p\": 1}}}",
         "s: point \"p\" has no figures"},
        {"{\"format\": \"touchstone baseline 1\", \"studies\": {\"s\": {\"p\": {\"figures\": {}, \"where\": "
         "{\"others\": {\"idle\": 1}}}}}}",
         "point \"p\" has a `where`"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char path[] = "/tmp/test_compare.XXXXXX", *error = NULL;
        int fd = mkstemp(path);
        assert_int_equal(write(fd, wrong[i][0], strlen(wrong[i][0])), strlen(wrong[i][0]));
        close(fd);
        assert_null(baseline_read(path, &error));
        assert_non_null(strstr(error, wrong[i][1]));
        assert_int_equal(strncmp(error, path, strlen(path)), 0);
        free(error);
        unlink(path);
    }
}

static void junit_has_a_case_a_point(void **state)
{
    (void)state;
    struct compare_rules rules = {0};
    struct compare_point *points[] = {
        compared("{\"virtual_time_s\": 1.5}", "{\"virtual_time_s\": 1.5}", NULL, false),
        compared("{\"virtual_time_s\": 1.0}", "{\"virtual_time_s\": 2.0}", NULL, false),
        compare_point("s<&>\"", "a\x01\xff\xc3\xa9", NULL, NULL, "exit status 1\n<oh>", &rules)};
    char *text = NULL;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    junit_write(points, 3, f);
    fclose(f);
    assert_non_null(strstr(
        text,
        "<testsuites name=\"touchstone\" tests=\"3\" failures=\"1\" errors=\"1\" time=\"3.500000000\">"));
    assert_non_null(strstr(text, "<testsuite name=\"s\" tests=\"2\" failures=\"1\" errors=\"0\""));
    assert_non_null(strstr(
        text, "<testcase classname=\"touchstone.s\" name=\"nodes 2\" time=\"1.500000000\"></testcase>"));
    assert_non_null(
        strstr(text, "<failure message=\"WORSE   s: nodes 2: virtual_time_s 1 -&gt; 2 (+100.00 %, +1)\">"));
    assert_non_null(
        strstr(text, "<testcase classname=\"touchstone.s&lt;&amp;&gt;&quot;\" name=\"a??\xc3\xa9\" "));
    assert_non_null(strstr(text, "<error message=\"exit status 1&#10;&lt;oh&gt;\">"));
    free(text);
    for (size_t i = 0; i < 3; i++)
        compare_free(points[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_last_digit_counts),
        cmocka_unit_test(more_is_worse_of_costs_and_less_of_speeds),
        cmocka_unit_test(other_figures_decide_only_if_a_tolerance_names_them),
        cmocka_unit_test(a_faster_base_makes_no_speed_worse),
        cmocka_unit_test(a_tolerance_is_relative_or_in_the_figures_unit),
        cmocka_unit_test(wrong_tolerances_are_named),
        cmocka_unit_test(a_tolerance_for_no_figure_is_found),
        cmocka_unit_test(points_come_and_go),
        cmocka_unit_test(where_files_are_and_wall_times_are_left_out),
        cmocka_unit_test(a_point_is_called_by_its_axes),
        cmocka_unit_test(time_that_moved_is_told_by_function_first),
        cmocka_unit_test(small_moves_have_four_digits),
        cmocka_unit_test(changes_stand_in_one_column),
        cmocka_unit_test(without_a_profile_it_is_told_by_class),
        cmocka_unit_test(a_baseline_is_the_same_when_read_again),
        cmocka_unit_test(what_is_no_baseline_is_told),
        cmocka_unit_test(junit_has_a_case_a_point),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
