/* test_chart.c - what a picture's gnuplot script says to draw. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lab/chart/chart_marks.h"
#include "lab/chart/chart_script.h"
#include "lab/chart/chart_style.h"

/* Lines a and b are equal. Panel 2's values span less than twice, panel 1's a hundred times. */
static const char RESULTS[] =
    "{ \"title\": \"It's\", \"baseline\": \"nodes 1\", \"axes\": { \"nodes\": [1, 10, 100],"
    "    \"line\": [\"a\", \"b\", \"c\"], \"panel\": [1, 2], \"group\": [2, 4] }, \"points\": ["
    "  { \"nodes\": 1, \"line\": \"a\", \"panel\": 1, \"group\": 2, \"time_s\": 1000 },"
    "  { \"nodes\": 10, \"line\": \"a\", \"panel\": 1, \"group\": 2, \"time_s\": 100 },"
    "  { \"nodes\": 100, \"line\": \"a\", \"panel\": 1, \"group\": 2, \"time_s\": 10 },"
    "  { \"nodes\": 1, \"line\": \"b\", \"panel\": 1, \"group\": 2, \"time_s\": 1000 },"
    "  { \"nodes\": 10, \"line\": \"b\", \"panel\": 1, \"group\": 2, \"time_s\": 100 },"
    "  { \"nodes\": 100, \"line\": \"b\", \"panel\": 1, \"group\": 2, \"time_s\": 10 },"
    "  { \"nodes\": 1, \"line\": \"c\", \"panel\": 1, \"group\": 2, \"time_s\": 1000 },"
    "  { \"nodes\": 10, \"line\": \"c\", \"panel\": 1, \"group\": 2, \"time_s\": 300 },"
    "  { \"nodes\": 1, \"line\": \"c\", \"panel\": 2, \"group\": 2, \"time_s\": 30 },"
    "  { \"nodes\": 10, \"line\": \"c\", \"panel\": 2, \"group\": 2, \"time_s\": 20 } ] }";

static const struct picture TIME = {.file = "pic",
                                    .title = "time",
                                    .x_label = "",
                                    .y_label = "",
                                    .figure = "time_s",
                                    .x = "nodes",
                                    .lines = "line",
                                    .panels = "panel",
                                    .best = "",
                                    .ratio = "",
                                    .lines_label = "",
                                    .panels_label = "",
                                    .log_x = true,
                                    .log_y = true};

static bool each(void *arg, bool (*visit)(void *, const json_t *, char **), void *to, char **error)
{
    size_t i;
    json_t *point;
    json_array_foreach((json_t *)arg, i, point) if (!visit(to, point, error)) return false;
    return true;
}

/* The script of the picture, malloc'd; the speed is 0.8 a node at each point. */
static char *script_of(struct picture p)
{
    char *text = NULL, *error = NULL;
    size_t size, i;
    json_t *root = json_loads(RESULTS, 0, NULL), *point;
    assert_non_null(root);
    json_array_foreach(json_object_get(root, "points"), i, point)
    {
        json_object_set_new(point, "speedup",
                            json_real(0.8 * json_number_value(json_object_get(point, "nodes"))));
        json_object_set_new(point, "speed_per_node", json_real(0.8));
        json_object_set_new(point, "host_idle_pct", json_real(30));
        json_object_set_new(point, "bytes",
                            json_real(1.2e6 * json_number_value(json_object_get(point, "nodes"))));
    }
    struct record_points points = {each, json_object_get(root, "points"), root};
    struct chart_data d;
    FILE *out = open_memstream(&text, &size);
    assert_true(chart_data_take(&points, &p, &d, &error));
    assert_true(chart_script_write(root, &p, &d, "dir", out));
    fclose(out);
    chart_data_free(&d);
    json_decref(root);
    return text;
}

/* The n'th place (from 0) at which the text has the words; NULL if there is none. */
static const char *nth(const char *text, const char *words, int n)
{
    const char *at = strstr(text, words);
    while (at && n--)
        at = strstr(at + 1, words);
    return at;
}

static int count(const char *text, const char *words)
{
    int n = 0;
    while (nth(text, words, n))
        n++;
    return n;
}

static void says(const char *text, const char *what)
{
    if (!strstr(text, what))
        fail_msg("'%s' is not in:\n%s", what, text);
}

static void range_of(const char *script, int n, double range[2])
{
    const char *at = nth(script, "set yrange [", n);
    assert_non_null(at);
    assert_int_equal(sscanf(at, "set yrange [%lf:%lf]", &range[0], &range[1]), 2);
}

/* Each panel had a range of its own, and panel 2, whose values span less than twice, a linear one. */
static void panels_have_the_same_range_and_scale(void **state)
{
    (void)state;
    char *script = script_of(TIME);
    double first[2], second[2];
    range_of(script, 0, first);
    range_of(script, 1, second);
    assert_true(first[0] == second[0] && first[1] == second[1]);
    assert_true(first[0] < 10 && first[1] > 1000);
    assert_int_equal(count(script, "\nset logscale y"), 4); /* two panels, PNG and SVG */
    assert_null(strstr(script, "unset logscale y"));
    free(script);
}

static void ranges_of_their_own_have_one_scale(void **state)
{
    (void)state;
    struct picture p = TIME;
    p.own_ranges = true;
    char *script = script_of(p);
    double first[2], second[2];
    range_of(script, 0, first);
    range_of(script, 1, second);
    assert_true(first[1] > 1000 && second[1] < 40);
    assert_int_equal(count(script, "unset logscale y"), 4);
    says(script, "each panel has a range of its own");
    free(script);
}

/* The first line of data in block $NAME, after skipping some. */
static const char *row(const char *script, const char *name, int skip)
{
    char begin[32];
    snprintf(begin, sizeof begin, "$%s << END\n", name);
    const char *at = strstr(script, begin);
    assert_non_null(at);
    at += strlen(begin);
    while (skip--)
        at = strchr(at, '\n') + 1;
    return at;
}

struct drawn {
    double x, y, size;
    int type;
};

static struct drawn mark(const char *script, const char *name, int skip)
{
    struct drawn m;
    assert_int_equal(sscanf(row(script, name, skip), "%lf %lf %lf %d", &m.x, &m.y, &m.size, &m.type), 4);
    return m;
}

/* Names on the x axis were joined by sloping lines, as if there were something between them. */
static void choices_are_points_side_by_side(void **state)
{
    (void)state;
    struct picture p = TIME;
    p.x = "line";
    p.lines = "nodes";
    p.panels = "";
    char *script = script_of(p);
    assert_null(strstr(script, "with lines "));
    assert_null(strstr(script, "linespoints"));
    assert_true(mark(script, "m0_0", 0).x < 1 && mark(script, "m0_2", 0).x > 1);
    assert_true(mark(script, "m0_2", 0).x < 1.5);
    free(script);
    p = TIME; /* the best of several values is a choice, too */
    p.best = "group";
    p.log_y = false;
    script = script_of(p);
    assert_null(strstr(script, "with lines "));
    free(script);
}

/* A picture of a ratio said "total_s" at its axis, one of best values only whose, and a program's figures had
 * their keys. */
static void axes_have_words(void **state)
{
    (void)state;
    struct picture p = TIME;
    p.panels = "";
    p.ratio = "panel";
    char *script = script_of(p);
    says(script, "set ylabel 'time, ratio'");
    free(script);
    p.figure = "speedup";
    script = script_of(p);
    assert_null(strstr(script, "title 'ideal'")); /* of a ratio there is none */
    free(script);
    p = TIME;
    p.best = "group";
    script = script_of(p);
    says(script, "set ylabel 'group with the least time'");
    free(script);
    p = TIME;
    p.figure = "host_idle_pct";
    script = script_of(p);
    says(script, "set ylabel 'host idle, %'");
    free(script);
}

static void speeds_have_their_ideal(void **state)
{
    (void)state;
    struct picture p = TIME;
    p.figure = "speedup";
    char *script = script_of(p);
    assert_int_equal(count(script, "plot x with lines"), 4);
    says(script, "title 'ideal'");
    says(script, "notes = 'group 2; baseline: nodes 1'");
    says(script, "set ylabel 'speed-up'"); /* not the figure's key, also in a picture of one's own */
    free(script);
    p.figure = "speed_per_node";
    script = script_of(p);
    assert_int_equal(count(script, "plot 1 with lines"), 4);
    free(script);
    p.x = "panel";
    p.panels = "nodes";
    script = script_of(p); /* the ideal is not known against another axis */
    assert_null(strstr(script, "ideal"));
    free(script);
    script = script_of(TIME);
    assert_null(strstr(script, "ideal"));
    assert_null(strstr(script, "baseline"));
    free(script);
}

/* The legend of one line had the line's name, and was cut off at the right. */
static void one_line_needs_no_name(void **state)
{
    (void)state;
    struct picture p = TIME;
    unsigned without[2], with[2];
    p.lines = "";
    p.panels = "";
    char *script = script_of(p);
    assert_int_equal(
        sscanf(strstr(script, "svg noenhanced size"), "svg noenhanced size %u,%u", &without[0], &without[1]),
        2);
    assert_null(strstr(script, "linespoints"));
    free(script);
    p.figure = "speedup";
    script = script_of(p);
    assert_int_equal(
        sscanf(strstr(script, "svg noenhanced size"), "svg noenhanced size %u,%u", &with[0], &with[1]), 2);
    assert_null(strstr(script, "linespoints"));
    says(script, "title 'ideal'");
    assert_true(with[0] >= without[0] + 74 + scale_text_width("ideal")); /* its sample, and its text */
    free(script);
}

/* A long title made the picture as wide as itself, many times as wide as its panels. */
static void a_long_heading_has_several_lines(void **state)
{
    (void)state;
    static char title[400];
    struct picture p = TIME;
    unsigned svg[2];
    for (size_t i = 0; i < sizeof title - 1; i++)
        title[i] = i % 8 == 7 ? ' ' : 'a';
    p.title = title;
    char *script = script_of(p);
    assert_int_equal(
        sscanf(strstr(script, "svg noenhanced size"), "svg noenhanced size %u,%u", &svg[0], &svg[1]), 2);
    assert_true(svg[0] < 1200 && scale_text_width(title) > 2900);
    says(script, "aaaaaaa'.\"\\n\".'aaaaaaa");
    free(script);
}

/* The axis's name had no room left of wide numbers, and was not drawn. */
static void wide_numbers_leave_room_for_the_name(void **state)
{
    (void)state;
    struct picture p = TIME;
    double margin;
    unsigned svg[2];
    p.figure = "bytes";
    p.log_y = false;
    char *script = script_of(p);
    assert_int_equal(sscanf(strstr(script, "set lmargin"), "set lmargin at screen %lf", &margin), 1);
    assert_int_equal(
        sscanf(strstr(script, "svg noenhanced size"), "svg noenhanced size %u,%u", &svg[0], &svg[1]), 2);
    assert_true(margin * svg[0] > scale_text_width("1.2e+08") + 36); /* the name's height is 22 */
    free(script);
    struct scale small = {true, 4e-5, 5e-4}, exact = {true, 1e-5, 1e-1};
    assert_int_equal(scale_widest_tic(&small), scale_text_width("0.00015"));
    assert_int_equal(scale_widest_tic(&exact), scale_text_width("0.0001"));
}

/* No node waits at any point: the axis went from -1 % to 1 %. */
static void nothing_is_no_less_than_zero(void **state)
{
    (void)state;
    assert_true(scale_of_values(0, 0, false).low == 0);
}

/* Of lines a and b there is no point in panel 2; line c takes 30 s of 1000 there, and 20 of 300. */
static void a_ratio_is_the_second_values_figure_by_the_firsts(void **state)
{
    (void)state;
    struct picture p = TIME;
    p.panels = "";
    p.ratio = "panel";
    char *script = script_of(p);
    double nodes, ratio;
    assert_int_equal(sscanf(row(script, "l0_2", 0), "%lf %lf", &nodes, &ratio), 2);
    assert_true(nodes == 1 && fabs(ratio - 0.03) < 1e-12);
    assert_int_equal(sscanf(row(script, "l0_2", 1), "%lf %lf", &nodes, &ratio), 2);
    assert_true(nodes == 10 && fabs(ratio - 2 / 30.0) < 1e-9);
    assert_int_equal(strncmp(row(script, "l0_0", 0), "END", 3), 0);
    says(script, "notes = 'group 2, panel 2 / 1'");
    free(script);
}

/* Line b hid line a. */
static void equal_lines_are_both_seen(void **state)
{
    (void)state;
    char *script = script_of(TIME);
    struct drawn a = mark(script, "m0_0", 1), b = mark(script, "m0_1", 1), c = mark(script, "m0_2", 1);
    assert_true(a.x == b.x && a.y == b.y);
    assert_true(a.size > 1.4 * b.size);
    assert_int_equal(a.type, style_hollow(style_of(0, 3, false).marker));
    assert_int_equal(b.type, style_of(1, 3, false).marker);
    assert_true(c.size == b.size);
    assert_true(mark(script, "m0_0", 0).size > mark(script, "m0_1", 0).size);
    says(script, "title 'b (= a)'");
    says(script, "title 'c'");
    free(script);
}

/* In grey print and for colour-blind eyes, marker and dashes tell lines apart; the width never does. */
static void lines_differ_in_marker_dashes_and_colour_only(void **state)
{
    (void)state;
    for (size_t i = 0; i < 7; i++)
        for (size_t k = 0; k < i; k++) {
            struct line_style a = style_of(i, 7, false), b = style_of(k, 7, false);
            assert_int_not_equal(a.marker, b.marker);
            assert_string_not_equal(a.dash, b.dash);
            assert_string_not_equal(a.colour, b.colour);
        }
    char *script = script_of(TIME);
    int lines = count(script, "with lines ");
    assert_int_equal(lines, 2 * 4);
    assert_int_equal(count(script, "with lines " CHART_WIDTH " dt "), lines);
    assert_int_equal(count(script, "with linespoints"), 2 * 3); /* the legend's samples */
    free(script);
}

/* Luminance of a colour, 0 to 255. */
static double grey_of(const char *colour)
{
    unsigned r, g, b;
    assert_int_equal(sscanf(colour, "#%2x%2x%2x", &r, &g, &b), 3);
    return 0.299 * r + 0.587 * g + 0.114 * b;
}

static void ordered_lines_go_from_dark_to_light(void **state)
{
    (void)state;
    for (size_t i = 1; i < 6; i++)
        assert_true(grey_of(style_of(i, 6, true).colour) > grey_of(style_of(i - 1, 6, true).colour) + 10);
    assert_true(grey_of(style_of(5, 6, true).colour) < 180); /* still seen on white */
}

static void the_legend_has_a_title_and_labels_beside_their_samples(void **state)
{
    (void)state;
    char *script = script_of(TIME);
    assert_int_equal(count(script, "Left reverse"), 2);
    assert_int_equal(count(script, "title 'line' left\n"), 2);
    says(script, "heading = 'It''s: time'");
    free(script);
    struct picture p = TIME;
    p.lines_label = "what it is of";
    p.panels_label = "case";
    p.x_label = "nodes\nsystem 'no command'"; /* results may be anybody's */
    script = script_of(p);
    assert_int_equal(count(script, "title 'what it is of' left\n"), 2);
    says(script, "set title 'case = 1'");
    says(script, "set xlabel 'nodes system ''no command'''\n");
    free(script);
}

static void a_png_has_twice_the_pixels(void **state)
{
    (void)state;
    unsigned png[2], svg[2];
    char *script = script_of(TIME);
    assert_int_equal(sscanf(strstr(script, "pngcairo noenhanced size"), "pngcairo noenhanced size %u,%u",
                            &png[0], &png[1]),
                     2);
    assert_int_equal(
        sscanf(strstr(script, "svg noenhanced size"), "svg noenhanced size %u,%u", &svg[0], &svg[1]), 2);
    assert_true(png[0] == 2 * svg[0] && png[1] == 2 * svg[1]);
    says(script, "fontscale 2 linewidth 2 pointscale 2");
    free(script);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(panels_have_the_same_range_and_scale),
        cmocka_unit_test(ranges_of_their_own_have_one_scale),
        cmocka_unit_test(choices_are_points_side_by_side),
        cmocka_unit_test(axes_have_words),
        cmocka_unit_test(speeds_have_their_ideal),
        cmocka_unit_test(one_line_needs_no_name),
        cmocka_unit_test(a_long_heading_has_several_lines),
        cmocka_unit_test(wide_numbers_leave_room_for_the_name),
        cmocka_unit_test(nothing_is_no_less_than_zero),
        cmocka_unit_test(a_ratio_is_the_second_values_figure_by_the_firsts),
        cmocka_unit_test(equal_lines_are_both_seen),
        cmocka_unit_test(lines_differ_in_marker_dashes_and_colour_only),
        cmocka_unit_test(ordered_lines_go_from_dark_to_light),
        cmocka_unit_test(the_legend_has_a_title_and_labels_beside_their_samples),
        cmocka_unit_test(a_png_has_twice_the_pixels)};
    return cmocka_run_group_tests_name("chart", tests, NULL, NULL);
}
