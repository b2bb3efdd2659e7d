/* test_spec.c - study files: the error of each kind of mistake names the line and what is allowed; the points
 * of a file. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "lab/study/points.h"
#include "lab/study/spec_read.h"

static const char good[] =
    "program = \"p\"; machine = \"delta\";\n"
    "axes = ( { name = \"nodes\"; values = ( 2, 16 ); },\n"
    "         { name = \"kind\"; cases = ( { label = \"a\"; }, { label = \"b\"; } ); } );\n";

static struct spec *read_text(const char *text, char **error)
{
    FILE *out = fopen("study.cfg", "w");
    assert_non_null(out);
    fputs(text, out);
    fclose(out);
    return spec_read("study.cfg", error);
}

static void mistakes_are_named_with_line_and_remedy(void **state)
{
    /* Lines after the good ones, or in their place, and the error. */
    static const struct {
        bool after;
        const char *text, *said;
    } MISTAKES[] = {
        {false, "program = ;", "study.cfg:1: syntax error (settings are written: key = value;)"},
        {false, "machine = \"m\";\naxes = ( );", "study.cfg: program: missing"},
        {false, "program = \"p\";\nmachine = \"m\";",
         "study.cfg: axes: missing: axes = ( { name = \"nodes\"; values = ( 1, 2, 4 ); } ); is a study of "
         "1, 2 and 4 nodes"},
        {true, "porgram = \"q\";",
         "study.cfg:4: porgram: unknown key; did you mean program? Known here: title, about, "},
        {true, "nodes = 4;", "study.cfg:4: nodes: there is an axis of that name; give only one of the two"},
        {true, "only = ( \"nods < 4\" );",
         "study.cfg:4: only: there is no axis nods; there are: nodes, kind"},
        {true, "only = ( \"kind < 4\" );",
         "study.cfg:4: only: kind is no number or axis of numbers: only = and != are allowed"},
        {true, "only = ( \"kind = c\" );",
         "study.cfg:4: only: c is neither an axis nor a value of kind; its values are: a, b"},
        {true, "cost = \"nodes * \";", "study.cfg:4: cost: something is missing at the end of \"nodes * \""},
        {true, "inputs = ( 4 );", "study.cfg:4: inputs: must hold names of files"},
        {true, "max_wall_s = 0.0;", "study.cfg:4: max_wall_s: 0 is out of range: 1e-09 to 1e+09 are allowed"},
        {true, "profile = 1;", "study.cfg:4: profile: must be true or false"},
        {true, "only = ( 4 );", "study.cfg:4: only: must hold texts such as \"group <= nodes\""},
        {true, "pictures = ( { file = \"f\"; x = \"group\"; y = \"s\"; } );",
         "study.cfg:4: x: there is no axis group; there are: nodes, kind"},
        {true, "pictures = ( { file = \"f\"; x = \"nodes\"; y = \"s\"; } );",
         "study.cfg:4: f: axis kind must be x, lines, panels, best or ratio"},
        {true,
         "pictures = ( { file = \"f\"; x = \"nodes\"; y = \"s\"; lines = \"nodes\"; panels = \"kind\"; } );",
         "study.cfg:4: f: axis nodes is given 2 times as x, lines, panels, best or ratio; once is allowed"},
        {false,
         "program = \"p\";\naxes = ( { name = \"nodes\"; values = ( 1, 2, 4 ); },\n"
         "{ name = \"machine\"; values = ( \"delta\" ); } );\n"
         "pictures = ( { file = \"f\"; x = \"machine\"; y = \"s\"; ratio = \"nodes\"; } );",
         "study.cfg:4: ratio: axis nodes has 3 values; a ratio needs two"},
        {true,
         "pictures = ( { file = \"f\"; x = \"nodes\"; least = \"s\"; ratio = \"kind\"; best = \"kind\"; } );",
         "study.cfg:4: ratio: cannot be drawn of the best: give only one of the two"},
        {true, "pictures = ( { file = \"f/g\"; x = \"nodes\"; y = \"s\"; } );",
         "study.cfg:4: file: \"f/g\" is no name: letters, digits, _ - . are allowed"},
        {true, "pictures = ( { file = \"f\"; x = \"nodes\"; } );", "study.cfg:4: y: missing"},
        {true, "pictures = ( { file = \"f\"; y = \"s\"; } );", "study.cfg:4: x: missing"},
        {true, "pictures = ( { file = \"f\"; x = \"nodes\"; y = \"s\"; logarithmic = \"z\"; } );",
         "study.cfg:4: logarithmic: must be \"x\", \"y\" or \"xy\""},
        {true, "pictures = ( { file = \"f\"; x = \"nodes\"; y = \"s\"; ranges = \"all\"; } );",
         "study.cfg:4: ranges: must be \"same\" (the panels' ranges of y; the default) or \"own\""},
        {true, "baseline = \"nodes\";", "study.cfg:4: baseline: must be a list"},
        {true, "baseline = ( 4 );", "study.cfg:4: baseline: must hold texts such as \"group=8\""},
        {true, "baseline = ( \"kind=c\" );", "study.cfg:4: baseline: \"kind=c\": axis kind has no value c"},
        {true, "baseline = ( \"knd\" );",
         "study.cfg:4: baseline: \"knd\": there is no axis knd; there are: nodes, kind"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( );",
         "study.cfg:2: axes: 0 axes: 1 to 16 are allowed"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; values = ( 1.5 ); } );",
         "study.cfg:2: nodes: 1.5 is not a number of nodes: whole, from 1 to 1048576"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; values = ( 4, 4 ); } );",
         "study.cfg:2: nodes: 4 is there twice"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; values = ( ); } );",
         "study.cfg:2: nodes: is empty: at least one value is needed"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; } );",
         "study.cfg:2: nodes: needs either values = ( ... ), values = { from ... }"},
        {false,
         "program = \"p\"; machine = \"m\";\n"
         "axes = ( { name = \"nodes\"; values = { from = 1; to = 8; }; } );",
         "study.cfg:2: nodes: a range needs either step = ...; or times = ...;"},
        {false,
         "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\";\n"
         "values = { from = 1; to = 8; times = 1; }; } );",
         "study.cfg:3: times: 1 is out of range"},
        {false,
         "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\";\n"
         "values = { from = 1; to = 4; step = 0.5; }; } );",
         "study.cfg:3: nodes: 1.5 is not a number of nodes: whole, from 1 to 1048576"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\";\nvalue = ( 1, 2 ); } );",
         "study.cfg:3: nodes: value takes a formula, such as \"nodes / 4\"; numbers are given as "
         "values = ( ... )"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"g\";\nvalue = \"nodes / 2\"; } );",
         "study.cfg:3: g: there is no axis nodes before this one"},
        {false,
         "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; values = ( { a = 1; } ); } );",
         "study.cfg:2: values: must hold numbers or texts; for more, give cases = ( { ... } );"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"g\"; values = ( 1 ); } );",
         "study.cfg:2: g: changes nothing; give set = ( \"KEY={}\" ) or arguments = \"-option {}\""},
        {false,
         "program = \"p\"; machine = \"m\";\naxes = ( { name = \"g\"; values = ( 1 ); set = ( \"a\" ); } );",
         "study.cfg:2: set: must hold texts KEY=VALUE, such as \"cfs.io_nodes={}\""},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"g\"; cases = ( 1 ); } );",
         "study.cfg:2: cases: must hold groups: { label = \"...\"; ... }"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( 1 );",
         "study.cfg:2: axes: must hold groups: { name = \"...\"; values = ( ... ); }"},
        {false,
         "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; values = ( 1 ); },\n"
         "{ name = \"nodes\"; values = ( 2 ); } );",
         "study.cfg:3: name: there is an axis nodes already"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof MISTAKES / sizeof *MISTAKES; i++) {
        char text[2048], *error = NULL;
        snprintf(text, sizeof text, "%s%s\n", MISTAKES[i].after ? good : "", MISTAKES[i].text);
        assert_null(read_text(text, &error));
        error[strnlen(error, strlen(MISTAKES[i].said))] = '\0';
        assert_string_equal(error, MISTAKES[i].said);
        free(error);
    }
}

static void an_axis_may_act_through_others(void **state)
{
    (void)state;
    char *error = NULL;
    struct spec *s = read_text("program = \"p\"; machine = \"m\"; nodes = 1;\n"
                               "axes = ( { name = \"g\"; values = ( 1, 2 ); },\n"
                               "{ name = \"h\"; value = \"2 * g\"; set = ( \"net.x={}\" ); } );",
                               &error);
    assert_non_null(s);
    assert_int_equal(s->product, 2);
    spec_free(s);
}

static void a_file_that_is_not_there(void **state)
{
    (void)state;
    char *error = NULL;
    assert_null(spec_read("none.cfg", &error));
    assert_string_equal(error, "none.cfg: cannot be read: No such file or directory");
    free(error);
}

/* The points' values on an axis, separated by blanks; "left out" if there are no points. */
static void assert_values(const char *rest, const char *axis, const char *expected)
{
    char text[2048], *error = NULL, said[256] = "";
    struct point p;
    snprintf(text, sizeof text, "program = \"p\"; machine = \"delta\";\n%s\n", rest);
    struct spec *s = read_text(text, &error);
    if (!s)
        fail_msg("%s", error);
    for (size_t i = 0; i < s->product; i++) {
        enum point_is is = point_make(s, i, &p, &error);
        if (is == POINT_WRONG) {
            snprintf(said, sizeof said, "%s", error);
            free(error);
        } else if (is == POINT_WANTED) {
            snprintf(said + strlen(said), sizeof said - strlen(said), "%s%s", *said ? " " : "",
                     p.value[spec_axis_index(s, spec_axis(s, axis))].text);
        }
    }
    assert_string_equal(said, expected);
    spec_free(s);
}

static void a_run_is_given_the_digits_of_the_file(void **state)
{
    (void)state;
    assert_values("axes = ( { name = \"f\"; values = ( 3.14159265358979, 0.1 ); arguments = \"{}\"; } );",
                  "f", "3.14159265358979 0.1");
}

static void ranges_hold_both_ends(void **state)
{
    (void)state;
    assert_values("axes = ( { name = \"nodes\"; values = { from = 1; to = 64; times = 4; }; } );", "nodes",
                  "1 4 16 64");
    assert_values("axes = ( { name = \"nodes\"; values = { from = 3; to = 10; step = 3; }; } );", "nodes",
                  "3 6 9");
    assert_values("nodes = 1; axes = ( { name = \"x\"; arguments = \"{}\"; "
                  "values = { from = 0; to = 0.3; step = 0.1; }; } );",
                  "x", "0 0.1 0.2 0.3");
}

static void axes_follow_from_others(void **state)
{
    (void)state;
    assert_values(
        "axes = ( { name = \"nodes\"; values = ( 4, 6 ); },\n { name = \"g\"; value = \"nodes / 4\"; },"
        " { name = \"h\"; value = \"2 * g\"; } );",
        "h", "2 3");
    assert_values("axes = ( { name = \"n\"; values = ( 4 ); arguments = \"{}\"; },\n"
                  " { name = \"nodes\"; value = \"n / 8\"; } );",
                  "nodes",
                  "study.cfg:3: nodes: \"n / 8\" is 0.5 at n 4, nodes ?: a whole number of nodes is needed");
}

static void arguments_may_be_for_some_points(void **state)
{
    char *error = NULL;
    struct point p;
    (void)state;
    struct spec *s =
        read_text("program = \"p\"; machine = \"delta\"; axes = ( { name = \"nodes\"; values = ( 4, 8 ); }, "
                  "{ name = \"many\"; value = \"nodes > 4\"; when = \"many\"; arguments = \"-x {}\"; } );",
                  &error);
    assert_non_null(s);
    assert_int_equal(point_make(s, 0, &p, &error), POINT_WANTED);
    assert_null(point_arguments(s, &p));
    assert_int_equal(point_make(s, 1, &p, &error), POINT_WANTED);
    char **words = point_arguments(s, &p);
    assert_string_equal(words[0], "-x");
    assert_string_equal(words[1], "1");
    words_free(words);
    spec_free(s);
}

static void points_are_left_out(void **state)
{
    static const char axes[] =
        "axes = ( { name = \"nodes\"; values = ( 2, 4, 8 ); },\n"
        "{ name = \"kind\"; cases = ( { label = \"a\"; }, { label = \"b\"; } ); } );\n";
    char text[1024];
    (void)state;
    snprintf(text, sizeof text, "%sonly = ( \"nodes < 8\", \"kind = b || nodes == 4\" );", axes);
    assert_values(text, "nodes", "2 4 4");
    snprintf(text, sizeof text, "%sonly = ( \"kind != 'a'\" );", axes);
    assert_values(text, "nodes", "2 4 8");
}

static int enter(void **state)
{
    static char dir[] = "/tmp/test-spec.XXXXXX";
    *state = dir;
    return mkdtemp(dir) && chdir(dir) == 0 ? 0 : -1;
}

static int leave(void **state)
{
    unlink("study.cfg");
    return chdir("/") == 0 && rmdir(*state) == 0 ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mistakes_are_named_with_line_and_remedy),
        cmocka_unit_test(an_axis_may_act_through_others),
        cmocka_unit_test(a_file_that_is_not_there),
        cmocka_unit_test(a_run_is_given_the_digits_of_the_file),
        cmocka_unit_test(ranges_hold_both_ends),
        cmocka_unit_test(axes_follow_from_others),
        cmocka_unit_test(arguments_may_be_for_some_points),
        cmocka_unit_test(points_are_left_out),
    };
    return cmocka_run_group_tests(tests, enter, leave);
}
