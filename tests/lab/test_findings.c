/* test_findings.c - the sentences of the page of findings follow from its figures. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "lab/chart/findings.h"

static const char RESULTS[] =
    "{ \"title\": \"T\", \"about\": \"Why.\", \"program\": \"p\", \"baseline\": \"nodes 1, scheme a\","
    "  \"axes\": { \"nodes\": [1, 2, 4, 8], \"scheme\": [\"a\", \"b\"] }, \"points\": ["
    "  { \"nodes\": 1, \"scheme\": \"a\", \"failure\": null, "
    "    \"total_s\": 1000, \"wait_s\": 7.02, \"call_time_s\": 2, "
    "    \"time_s\": 8.0, \"speedup\": 1 },"
    "  { \"nodes\": 1, \"scheme\": \"b\", \"failure\": null, "
    "    \"wait_s\": 5, \"call_time_s\": 4, "
    "    \"time_s\": 8.0, \"speedup\": 1 },"
    "  { \"nodes\": 2, \"scheme\": \"a\", \"failure\": null, "
    "    \"total_s\": 7.02, \"wait_s\": 1000, \"call_time_s\": 24.5, "
    "    \"time_s\": 4.0, \"speedup\": 2 },"
    "  { \"nodes\": 2, \"scheme\": \"b\", \"failure\": null, "
    "    \"wait_s\": 5, \"call_time_s\": 5, "
    "    \"time_s\": 5.0, \"speedup\": 1.6 },"
    "  { \"nodes\": 4, \"scheme\": \"a\", \"failure\": null, \"time_s\": 3.9, \"speedup\": 2.05 },"
    "  { \"nodes\": 4, \"scheme\": \"b\", \"failure\": null, \"time_s\": 3.0, \"speedup\": 2.7 },"
    "  { \"nodes\": 8, \"scheme\": \"a\", \"failure\": null, \"time_s\": 6.0, \"speedup\": 1.3 },"
    "  { \"nodes\": 8, \"scheme\": \"b\", \"failure\": \"crashed\" } ] }\n";

/* Writes the results to dir/results.json and reads them. */
static void read_results(const char *results, const char *dir, struct record_points *points)
{
    char path[64], *error = NULL;
    snprintf(path, sizeof path, "%s/results.json", dir);
    FILE *f = fopen(path, "w");
    fputs(results, f);
    fclose(f);
    assert_true(record_read(path, points, &error));
    unlink(path);
}

/* The page of the results with one picture of the figure; malloc'd. */
static char *page_of_results(const char *results, const char *figure, const char *x, const char *lines,
                             const char *best)
{
    char dir[] = "/tmp/findings.XXXXXX", path[64], *error = NULL, *text = calloc(1, 8192);
    struct record_points points;
    assert_non_null(mkdtemp(dir));
    read_results(results, dir, &points);
    struct picture picture = {.file = "pic",
                              .title = "title",
                              .x_label = "",
                              .y_label = "",
                              .figure = figure,
                              .x = x,
                              .lines = *best ? "" : lines,
                              .panels = "",
                              .best = best,
                              .ratio = "",
                              .lines_label = "",
                              .panels_label = ""};
    assert_true(findings_write(&points, &picture, *figure ? 1 : 0, dir, &error));
    record_free(&points);
    snprintf(path, sizeof path, "%s/findings.md", dir);
    FILE *f = fopen(path, "r");
    assert_true(fread(text, 1, 8191, f) > 0);
    fclose(f);
    unlink(path);
    rmdir(dir);
    return text;
}

static char *page_of(const char *figure, const char *x, const char *lines, const char *best)
{
    return page_of_results(RESULTS, figure, x, lines, best);
}

static char *page(const char *figure, const char *best)
{
    return page_of(figure, "nodes", "scheme", best);
}

static void says(const char *text, const char *what)
{
    if (!strstr(text, what))
        fail_msg("'%s' is not in:\n%s", what, text);
}

static void table_and_least(void **state)
{
    (void)state;
    char *text = page("time_s", "");
    says(text, "# T\n");
    says(text, "Why.\n");
    says(text, "p at 8 points: 4 values of nodes, 2 of scheme.\n");
    says(text, "\n1 failed");
    says(text, "![title](pic.png)");
    says(text, "| 4 | 3.900 | 3.000 |");
    says(text, "| 8 | 6.000 | - |");
    says(text, "- scheme a: 8.000 to 6.000 from 1 to 8 nodes, 25 % less; least, 3.900, at 4 nodes; within "
               "a tenth of it from 2 to 4.");
    says(text, "- scheme b: 8.000 to 3.000 from 1 to 4 nodes, 2.67 times faster; least, 3.000, at 4 nodes.");
    says(text, "- The lowest line: scheme a at 2 nodes; scheme b at 4 nodes.");
    free(text);
}

static void speeds_are_best_when_high(void **state)
{
    (void)state;
    char *text = page("speedup", "");
    says(text, "- scheme b: 1.000 to 2.700 from 1 to 4 nodes, 2.70 times higher; most, 2.700, at 4 nodes.");
    says(text, "In the table: speed-up; baseline: nodes 1, scheme a.");
    says(text, "- The highest line: scheme a at 2 nodes; scheme b at 4 nodes.");
    free(text);
}

static void best_value_of_an_axis(void **state)
{
    (void)state;
    char *text = page("time_s", "scheme");
    says(text, "In the table: scheme with the least time.");
    says(text, "| 2 | a |");
    says(text, "| 4 | b |");
    free(text);
}

/* A factor of a thousandth was "x 0.00702", which nobody reads as 142 times faster. */
static void factors_are_said_in_words(void **state)
{
    (void)state;
    char *text = page("total_s", "");
    says(text, "1000.00 to 7.02 from 1 to 2 nodes, 142 times faster;");
    assert_null(strstr(text, "(x "));
    free(text);
    text = page("wait_s", "");
    says(text, "7.02 to 1000.00 from 1 to 2 nodes, 142 times higher;");
    says(text, "- scheme b: 5.000 at all points.\n"); /* "least, 5.000, at nodes 1" says nothing */
    free(text);
    text = page("call_time_s", "");
    says(text, "2.000 to 24.500 from 1 to 2 nodes, 12.2 times slower;");
    says(text, "4.000 to 5.000 from 1 to 2 nodes, 25 % more;");
    free(text);
}

/* Between names there is no from and to. */
static void names_have_no_first_and_last(void **state)
{
    (void)state;
    char *text = page_of("time_s", "scheme", "nodes", "");
    says(text, "- 2 nodes: least, 4.000, at scheme a.\n");
    assert_null(strstr(text, "from scheme"));
    free(text);
}

/* Of two machines that were as good, the first was named alone. */
static void all_that_are_best_are_named(void **state)
{
    (void)state;
    static const char THREE[] = "{ \"title\": \"T\", \"about\": \"\", \"program\": \"p\", \"baseline\": null,"
                                "  \"axes\": { \"machine\": [\"a\", \"b\", \"c\"] }, \"points\": ["
                                "  { \"machine\": \"a\", \"failure\": null, \"idle_pct\": 0 },"
                                "  { \"machine\": \"b\", \"failure\": null, \"idle_pct\": 3 },"
                                "  { \"machine\": \"c\", \"failure\": null, \"idle_pct\": 0 } ] }\n";
    char *text = page_of_results(THREE, "idle_pct", "machine", "", "");
    says(text, "least, 0.000, at machine a and c.\n");
    free(text);
}

/* The page said of every study that points had been left out, also of one that had run all. */
static void says_how_many_are_left_out(void **state)
{
    (void)state;
    static const char three_of_four[] =
        "{ \"title\": \"T\", \"about\": \"\", \"program\": \"p\", \"baseline\": \"nodes 1\","
        "  \"axes\": { \"nodes\": [1, 2], \"group\": [1, 2] }, \"points\": ["
        "  { \"nodes\": 1, \"group\": 1, \"failure\": null, \"time_s\": 8.0 },"
        "  { \"nodes\": 2, \"group\": 1, \"failure\": null, \"time_s\": 8.0 },"
        "  { \"nodes\": 2, \"group\": 2, \"failure\": null, \"time_s\": 4.0 } ] }\n";
    char *text = page_of_results(three_of_four, "time_s", "nodes", "group", "");
    says(text, "2 of group. The study's `only` leaves out 1 combination.\n");
    free(text);
}

static void one_point_is_no_points(void **state)
{
    (void)state;
    static const char one[] =
        "{ \"title\": \"T\", \"about\": \"\", \"program\": \"p\", \"baseline\": \"nodes 4\","
        "  \"axes\": { \"nodes\": [4] }, \"points\": ["
        "  { \"nodes\": 4, \"failure\": null, \"time_s\": 8.0, \"idle_pct\": 12.5 } ] }\n";
    char *text = page_of_results(one, "time_s", "nodes", "", "");
    says(text, "p at 1 point: 1 value of nodes.\n");
    free(text);
    text = page_of_results(one, "", "nodes", "", ""); /* as a study has it: no picture */
    says(text, "1 value of nodes.\n\nTime: 8.000 s. Idle: 12.5 % of all nodes' time.\n\n"
               "No axis has several values, so there is no picture.");
    free(text);
}

/* A time of 40 us was "0.00004000" in the table. */
static void short_times_are_in_their_own_unit(void **state)
{
    (void)state;
    static const char short_ones[] =
        "{ \"title\": \"T\", \"about\": \"\", \"program\": \"p\", \"baseline\": \"nodes 1\","
        "  \"axes\": { \"nodes\": [1, 2] }, \"points\": ["
        "  { \"nodes\": 1, \"failure\": null, \"time_s\": 0.00004, \"total_s\": 0.001 },"
        "  { \"nodes\": 2, \"failure\": null, \"time_s\": 0.0004, \"total_s\": 0.09 } ] }\n";
    char *text = page_of_results(short_ones, "time_s", "nodes", "", "");
    says(text, "In the table: time, us.");
    says(text, "| nodes | time, us |\n|--:|--:|\n| 1 | 40.00 |\n| 2 | 400.00 |\n");
    free(text);
    text = page_of_results(short_ones, "total_s", "nodes", "", "");
    says(text, "| nodes | total time, ms |\n|--:|--:|\n| 1 | 1.000 |\n| 2 | 90.000 |\n");
    free(text);
}

/* One value was 0.9967 in one column and 0.996697 in the next. */
static void columns_have_equal_decimals(void **state)
{
    (void)state;
    static const char two_sizes[] =
        "{ \"title\": \"T\", \"about\": \"\", \"program\": \"p\", \"baseline\": \"nodes 1\","
        "  \"axes\": { \"nodes\": [1, 2], \"scheme\": [\"a\", \"b\"] }, \"points\": ["
        "  { \"nodes\": 1, \"scheme\": \"a\", \"failure\": null, \"time_s\": 9.5, \"wide_s\": 1.25 },"
        "  { \"nodes\": 1, \"scheme\": \"b\", \"failure\": null, \"time_s\": 9.5, \"wide_s\": 1000 },"
        "  { \"nodes\": 2, \"scheme\": \"a\", \"failure\": null, \"time_s\": 8.5, \"wide_s\": 2.5 },"
        "  { \"nodes\": 2, \"scheme\": \"b\", \"failure\": null, \"time_s\": 0.25, \"wide_s\": 2000 } ] }\n";
    char *text = page_of_results(two_sizes, "time_s", "nodes", "scheme", "");
    says(text, "| 1 | 9.5000 | 9.5000 |\n| 2 | 8.5000 | 0.2500 |\n");
    free(text);
    text = page_of_results(two_sizes, "wide_s", "nodes", "scheme", ""); /* seven digits would be too many */
    says(text, "| 1 | 1.250 | 1000 |\n| 2 | 2.500 | 2000 |\n");
    free(text);
}

/* Of lines with one value, the page named the first as the lowest. */
static void lines_with_one_value_win_together(void **state)
{
    (void)state;
    static const char ties[] =
        "{ \"title\": \"T\", \"about\": \"\", \"program\": \"p\", \"baseline\": \"nodes 1\","
        "  \"axes\": { \"nodes\": [1, 2], \"scheme\": [\"a\", \"b\", \"c\"] }, \"points\": ["
        "  { \"nodes\": 1, \"scheme\": \"a\", \"failure\": null, \"time_s\": 8.0 },"
        "  { \"nodes\": 1, \"scheme\": \"b\", \"failure\": null, \"time_s\": 8.0 },"
        "  { \"nodes\": 1, \"scheme\": \"c\", \"failure\": null, \"time_s\": 9.0 },"
        "  { \"nodes\": 2, \"scheme\": \"a\", \"failure\": null, \"time_s\": 4.0 },"
        "  { \"nodes\": 2, \"scheme\": \"b\", \"failure\": null, \"time_s\": 5.0 },"
        "  { \"nodes\": 2, \"scheme\": \"c\", \"failure\": null, \"time_s\": 6.0 } ] }\n";
    char *text = page_of_results(ties, "time_s", "nodes", "scheme", "");
    says(text, "- The lowest line: scheme a and b at 1 node; scheme a at 2 nodes.\n");
    free(text);
}

/* The values that the message's names came from were freed with them. */
static void message_of_a_figure_leaves_the_points(void **state)
{
    (void)state;
    char dir[] = "/tmp/findings.XXXXXX";
    struct record_points points;
    assert_non_null(mkdtemp(dir));
    read_results(RESULTS, dir, &points);
    rmdir(dir);
    char *before = json_dumps(points.header, 0), *text = record_no_figure(&points, "x_s");
    char *after = json_dumps(points.header, 0), *misspelt = record_no_figure(&points, "speedpu");
    assert_string_equal(
        text, "no point has a figure x_s; there are: total_s, wait_s, call_time_s, time_s, speedup");
    says(misspelt, "no point has a figure speedpu; did you mean speedup? There are: total_s, ");
    free(misspelt);
    assert_non_null(after);
    assert_string_equal(before, after);
    free(before);
    free(after);
    free(text);
    record_free(&points);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(table_and_least),
                                       cmocka_unit_test(speeds_are_best_when_high),
                                       cmocka_unit_test(best_value_of_an_axis),
                                       cmocka_unit_test(factors_are_said_in_words),
                                       cmocka_unit_test(names_have_no_first_and_last),
                                       cmocka_unit_test(all_that_are_best_are_named),
                                       cmocka_unit_test(says_how_many_are_left_out),
                                       cmocka_unit_test(one_point_is_no_points),
                                       cmocka_unit_test(short_times_are_in_their_own_unit),
                                       cmocka_unit_test(columns_have_equal_decimals),
                                       cmocka_unit_test(lines_with_one_value_win_together),
                                       cmocka_unit_test(message_of_a_figure_leaves_the_points)};
    return cmocka_run_group_tests_name("findings", tests, NULL, NULL);
}
