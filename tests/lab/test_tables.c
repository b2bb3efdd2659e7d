/* test_tables.c - the making of tables, with a script in place of the simulator.
 *
 * For the script a run on N nodes takes 1200 / N s. It records its arguments, fails when told to, and when
 * told to be patient ends a run of table 2 only when table 1 is printed.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lab/tables/tables.h"

static const char stand_in[] =
    "#!/bin/sh\n"
    "[ \"$1 $2 $3 $5 $7\" = 'run -q -m -n --json' ] || { echo \"bad call: $*\" >&2; exit 64; }\n"
    "machine=$4 nodes=$6 json=$8; shift 8\n"
    "echo \"$machine $nodes $*\" >>calls\n"
    "if [ $nodes = 8 ] && [ -e fail ]; then echo 'node 3 at 1.5 s: it broke' >&2; exit 1; fi\n"
    "case \"$*\" in *-noreassign*) tries=0; while [ -e patient ] && ! grep -q 'Table 1' said; do\n"
    "    sleep 0.1; tries=$((tries + 1)); [ $tries -lt 600 ] || exit 1; done ;; esac\n"
    "echo 'Some words for people: 3'\n"
    "case \"$*\" in *-slow*) s=2400 ;; *) s=1200 ;; esac\n"
    "awk -v n=$nodes -v s=$s 'BEGIN { printf \"total_s %.6f\\n\", s / n }'\n"
    "echo polygons 121486; echo polygons_by_isovalue 1 2 3; echo host_idle_pct 0.25\n"
    "[ $nodes = 1 ] || echo slave_idle_pct 1.5\n"
    "echo \"{\\\"machine\\\": \\\"$machine\\\", \\\"digest\\\": \\\"00ff\\\", \\\"virtual_time_s\\\": 1.5,"
    " \\\"messages\\\": 12, \\\"bytes\\\": 34, \\\"wall_time_s\\\": 0.$$, \\\"node\\\": [1]}\" >$json\n";

static const char paper_cfg[] =
    "machine = \"delta\"; program = \"app/model\";\n"
    "tables = ( { table = 1; title = \"one\"; group = 0; arguments = \"-approx 111\"; several_groups = "
    "\"\";\n"
    "  rows = ( ( 1, 1000.0, 0.0, \"-\", \"-\", 1.0 ), ( 8, 150.0, 0.1, 1.0, 0.0, 0.9 ),\n"
    "           ( 16, 80.0, 0.1, 2, \"-\", 0.8 ) ); },\n"
    "  { table = 2; title = \"two\"; group = 8; arguments = \"-approx 111\"; several_groups = "
    "\"-noreassign\";\n"
    "  rows = ( ( 1, 1000.0, 0.0, \"-\", \"-\", 1.0 ), ( 8, 150.0, 0.1, 1.0, 0.0, 0.9 ),\n"
    "           ( 16, 80.0, \"-\", \"-\", \"-\", 0.8 ) ); } );\n";

static void write_file(const char *path, const char *text)
{
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs(text, out);
    fclose(out);
}

static char *read_text(const char *path)
{
    char *text = calloc(1, 65536);
    FILE *in = fopen(path, "r");
    assert_non_null(in);
    assert_non_null(text);
    assert_true(fread(text, 1, 65535, in) > 0);
    fclose(in);
    return text;
}

/* Makes the tables in the current folder; `said` gets the printed text, `progress` the text of progress. */
static const char *choices; /* the file for the choices */

static enum tables_end make(const unsigned *wanted, char **error)
{
    FILE *out = fopen("said", "w"), *progress = fopen("progress", "w");
    int signal = 0;
    assert_non_null(out);
    assert_non_null(progress);
    struct tables_options o = {.runner = "./stand-in",
                               .programs = "build",
                               .home = ".",
                               .dir = "made/out",
                               .wanted = wanted,
                               .at_once = 2,
                               .choices = choices,
                               .out = out,
                               .progress = progress,
                               .signal = &signal};
    enum tables_end end = tables_make(&o, error);
    fclose(out);
    fclose(progress);
    return end;
}

static json_t *row(json_t *root, size_t i)
{
    return json_array_get(json_object_get(root, "rows"), i);
}

static double number(json_t *object, const char *key)
{
    json_t *value = json_object_get(object, key);
    assert_true(json_is_number(value));
    return json_number_value(value);
}

static void same_rows_run_once_with_the_right_arguments(void **state)
{
    (void)state;
    assert_int_equal(make(NULL, NULL), TABLES_DONE);
    assert_int_equal(system("LC_ALL=C sort calls >sorted"), 0);
    char *calls = read_text("sorted");
    assert_string_equal(calls, "delta 1 build/app/model -approx 111 -group 1\n"
                               "delta 16 build/app/model -approx 111 -group 16\n"
                               "delta 16 build/app/model -approx 111 -group 8 -noreassign\n"
                               "delta 8 build/app/model -approx 111 -group 8\n");
    free(calls);
}

static void a_table_is_printed_when_its_runs_are_done(void **state)
{
    (void)state;
    write_file("patient", "");
    assert_int_equal(make(NULL, NULL), TABLES_DONE);
    char *said = read_text("said"), *first = strstr(said, "Table 1:"), *second = strstr(said, "Table 2:");
    assert_true(first && second && first < second);
    assert_null(strstr(first + 1, "Table 1:"));
    free(said);
}

static void json_holds_both_sides(void **state)
{
    (void)state;
    assert_int_equal(make(NULL, NULL), TABLES_DONE);
    json_t *root = json_load_file("made/out/tables.json", 0, NULL);
    assert_int_equal(json_array_size(json_object_get(root, "rows")), 6);
    json_t *r = row(root, 1);
    assert_float_equal(number(r, "table"), 1, 0);
    assert_float_equal(number(r, "nodes"), 8, 0);
    assert_float_equal(number(r, "total_s"), 150, 0);
    assert_float_equal(number(r, "paper_total_s"), 150, 0);
    assert_float_equal(number(r, "error_pct"), 0, 1e-9);
    assert_float_equal(number(r, "speed_per_node"), 1, 1e-9);
    assert_float_equal(number(r, "polygons"), 121486, 0);
    assert_string_equal(json_string_value(json_object_get(r, "digest")), "00ff");
    assert_int_equal(json_array_size(json_object_get(r, "polygons_by_isovalue")), 3);
    assert_true(json_is_null(json_object_get(row(root, 0), "slave_idle_pct")));
    assert_true(json_is_null(json_object_get(row(root, 5), "paper_host_idle_pct")));
    assert_null(json_object_get(r, "node"));
    json_t *summary = json_object_get(root, "summary");
    /* 20 % at 1 node, 0 at 8, -6.25 at 16, twice: the shared runs count once. */
    assert_float_equal(number(summary, "rows"), 4, 0);
    assert_float_equal(number(summary, "mean_error_pct"), (20 + 6.25 + 6.25) / 4, 1e-9);
    assert_float_equal(number(summary, "worst_error_pct"), 20, 1e-9);
    json_decref(root);
}

static void only_wall_times_differ_between_two_runs(void **state)
{
    (void)state;
    assert_int_equal(make(NULL, NULL), TABLES_DONE);
    assert_int_equal(system("grep -v wall_time made/out/tables.json >first"), 0);
    assert_int_equal(make(NULL, NULL), TABLES_DONE);
    assert_int_equal(system("grep -v wall_time made/out/tables.json | cmp - first"), 0);
}

static void one_table_alone(void **state)
{
    (void)state;
    assert_int_equal(make((unsigned[]){2, 0}, NULL), TABLES_DONE);
    assert_int_equal(access("made/out/table-2.png", R_OK), 0);
    assert_int_equal(access("made/out/table-2.svg", R_OK), 0);
    assert_int_not_equal(access("made/out/table-1.png", R_OK), 0);
    char *said = read_text("said");
    assert_non_null(strstr(said, "Table 2: two"));
    assert_null(strstr(said, "Table 1: one"));
    free(said);
}

static void a_row_that_fails_is_named_and_the_rest_is_there(void **state)
{
    (void)state;
    write_file("fail", "");
    assert_int_equal(make(NULL, NULL), TABLES_INCOMPLETE);
    char *said = read_text("said"), *progress = read_text("progress");
    assert_non_null(strstr(said, "tables 1, 2; 8 nodes: exit status 1: node 3 at 1.5 s: it broke"));
    assert_non_null(strstr(progress, "tables 1, 2; 8 nodes: exit status 1"));
    json_t *root = json_load_file("made/out/tables.json", 0, NULL);
    assert_true(json_is_null(json_object_get(row(root, 1), "total_s")));
    assert_true(json_is_string(json_object_get(row(root, 1), "failure")));
    assert_float_equal(number(row(root, 2), "total_s"), 75, 0);
    json_decref(root);
    free(said);
    free(progress);
}

static void fitted_factors_are_named(void **state)
{
    (void)state;
    write_file(
        "bench/paper/fitted.cfg",
        "factors = ( { file = \"slice.c\"; factor = 1.1; fitted_to = \"table 1, 1 node\"; } );\n"
        "constants = ( ( \"-keep 9\", \"table 5\" ) ); policies = ( ( \"-gran 1\", \"table 1\" ) );\n");
    assert_int_equal(make(NULL, NULL), TABLES_DONE);
    char *said = read_text("said");
    assert_non_null(strstr(said, "cost    slice.c x 1.1: table 1, 1 node"));
    assert_non_null(strstr(said, "number  -keep 9: table 5"));
    assert_non_null(strstr(said, "policy  -gran 1: table 1"));
    free(said);
}

static void each_alternative_to_a_choice_is_run_and_its_errors_are_given(void **state)
{
    (void)state;
    write_file(
        "bench/paper/fitted.cfg",
        "factors = ( );\n"
        "constants = ( ( \"net = 5\", \"table 2\", \"--set net=6\" ) );\n"
        "policies = ( ( \"fast\", \"table 1\", \"-slow 1\", \"-slow 2\" ), ( \"alone\", \"table 1\" ) );\n");
    choices = "made/choices.md";
    assert_int_equal(make(NULL, NULL), TABLES_DONE);
    choices = NULL;
    char *said = read_text("made/choices.md"), *calls = read_text("calls");
    assert_non_null(
        strstr(said, "\n| nothing changed |  | 8.12 | +20.00 (1:1) | 15.10 | -21.88 (1:16) | 121486 |\n"));
    assert_non_null(
        strstr(said, "\n| fast | `-slow 1` | 103.75 | +140.00 (1:1) | 15.10 | -21.88 (1:16) | 121486 |\n"));
    assert_non_null(strstr(said, "\n|  | `-slow 2` | 103.75 |"));
    assert_non_null(strstr(said, "\n| alone | not tried |"));
    assert_non_null(strstr(calls, "\ndelta 16 build/app/model -approx 111 -group 8 -noreassign -slow 2\n"));
    assert_non_null(strstr(calls, "\ndelta 16 --set net=6 build/app/model -approx 111 -group 16\n"));
    free(calls);
    free(said);
}

static void bad_figures_are_named_by_line(void **state)
{
    (void)state;
    char *error = NULL;
    write_file("bench/paper/paper.cfg",
               "machine = \"m\"; program = \"p\";\ntables = ( { table = 1; title = \"t\";\n"
               "group = 0; arguments = \"a\"; rows = (\n( 1, \"x\" ) ); } );\n");
    assert_int_equal(make(NULL, &error), TABLES_ERROR);
    assert_string_equal(error,
                        "./bench/paper/paper.cfg:4: total_s: must be a number from 0 up, or \"-\" for none");
    free(error);
}

static void a_place_that_cannot_be_written(void **state)
{
    (void)state;
    char *error = NULL;
    write_file("made", "a file where the folder should be");
    assert_int_equal(make(NULL, &error), TABLES_ERROR);
    assert_string_equal(error, "made/out cannot be made: Not a directory");
    free(error);
}

/* Each test runs in a folder of its own. */
static int enter(void **state)
{
    char *dir = strdup("/tmp/test_tables.XXXXXX");
    *state = dir;
    if (!mkdtemp(dir) || chdir(dir) != 0 || mkdir("bench", 0777) != 0 || mkdir("bench/paper", 0777) != 0)
        return -1;
    write_file("stand-in", stand_in);
    write_file("bench/paper/paper.cfg", paper_cfg);
    write_file("bench/paper/fitted.cfg", "factors = ();\n");
    return chmod("stand-in", 0755);
}

static int leave(void **state)
{
    char command[64];
    snprintf(command, sizeof command, "rm -r %s", (char *)*state);
    free(*state);
    return chdir("/") == 0 ? system(command) : -1;
}

int main(void)
{
#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, enter, leave)
    const struct CMUnitTest tests[] = {
        IN_FOLDER(a_table_is_printed_when_its_runs_are_done),
        IN_FOLDER(same_rows_run_once_with_the_right_arguments),
        IN_FOLDER(json_holds_both_sides),
        IN_FOLDER(only_wall_times_differ_between_two_runs),
        IN_FOLDER(one_table_alone),
        IN_FOLDER(a_row_that_fails_is_named_and_the_rest_is_there),
        IN_FOLDER(fitted_factors_are_named),
        IN_FOLDER(each_alternative_to_a_choice_is_run_and_its_errors_are_given),
        IN_FOLDER(bad_figures_are_named_by_line),
        IN_FOLDER(a_place_that_cannot_be_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
