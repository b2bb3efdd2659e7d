/* tables_command.c - touchstone tables: the paper's tables, reproduced. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lab/commands/lab_commands.h"
#include "cli/installation.h"
#include "cli/options.h"
#include "cli/say.h"
#include "lab/tables/tables.h"

enum { MAX_TABLES = 16 };

struct arguments {
    unsigned tables[MAX_TABLES + 1]; /* ended by 0; none: all */
    const char *dir, *report, *choices, *explain, *json;
    unsigned jobs;
    bool ties;
};

static const struct argp_option OPTIONS[] = {
    {"tables", 't', "TABLES", 0, "Numbers of the tables, such as 1,2; default all", 1},
    {"output", 'o', "DIR", 0, "Folder for tables.json and the pictures table-N.png and .svg; default out", 1},
    {"ties", CLI_FLAG(arguments, ties), NULL, 0,
     "Run tie-sensitive rows 8 times more, with latencies 2 % less to 2 % more; show the time's range", 1},
    {"report", CLI_TEXT(arguments, report), "FILE", 0,
     "Write a report in Markdown: errors, the paper's rounding, what was fitted, where time goes", 1},
    {"choices", CLI_TEXT(arguments, choices), "FILE", 0,
     "Write in Markdown what changes with each choice that was made with the paper's tables in view; half a "
     "minute each",
     1},
    {"explain", CLI_TEXT(arguments, explain), "ROW", 0,
     "Only show where the time of a row, such as 1:128, goes: by activity, processor and layer", 1},
    {"json", CLI_TEXT(arguments, json), "FILE", 0,
     "Write what DIR/tables.json has, or with --explain the row's, as JSON; '-' is standard output, and the "
     "tables go to standard error",
     1},
    {0}};

static const char DOC[] =
    "Runs the model program as each row of Tables 1-5 of Bajaj & Lin, \"Scalar Field Modeling & "
    "Visualization on the Intel Delta\", was run, and sets its figures beside the paper's. Rows that are "
    "the same run are run once.\v"
    "Rows are kept in DIR/journal until all are there: after Ctrl-C or kill -9 the same command "
    "continues. DIR then has tables.json and a picture of each table.\n\n"
    "Exit status:\n"
    "  0    every row is there\n"
    "  1    a row or a picture failed; it is named, and all others are there\n"
    "  64   wrong arguments\n"
    "  65   the program or the paper's figures cannot be used, or the results not\n"
    "       written\n"
    "  128  and more: stopped by the signal of that number less 128\n\n"
    "Example:\n"
    "  touchstone tables -t 1,2 -o out/tables";

/* text: numbers, such as "1,2" */
static void read_tables(struct argp_state *state, const char *text, unsigned tables[])
{
    char *end = (char *)(uintptr_t)text;
    for (int n = 0; n < MAX_TABLES; n++) {
        const char *number = n ? end + 1 : end;
        long value = strtol(number, &end, 10);
        if (end == number || value < 1 || value > 99 || (*end && *end != ','))
            break;
        tables[n] = (unsigned)value, tables[n + 1] = 0;
        if (!*end)
            return;
    }
    argp_error(state, "-t takes numbers of tables, such as 1,2, not '%s'", text);
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->jobs;
    else if (key == 't')
        read_tables(state, arg, a->tables);
    else if (key == 'o')
        a->dir = arg;
    else if (key == ARGP_KEY_END && a->explain && (a->tables[0] || a->ties || a->report || a->choices))
        argp_error(state,
                   "--explain only shows a row: --tables, --ties, --report and --choices are for tables");
    else
        return cli_store(key, arg, state);
    return 0;
}

int cli_tables(int argc, char **argv)
{
    static const struct argp_child CHILDREN[] = {{&CLI_JOBS, 0, NULL, 0}, {0}};
    static const struct argp ARGP = {OPTIONS, parse, NULL, DOC, CHILDREN, NULL, NULL};
    struct arguments a = {.dir = "out"};
    struct cli_installation places;
    char *error = NULL;
    int signal = 0;
    cli_parse(&ARGP, "touchstone tables", 0, argc, argv, &a);
    if (!cli_find_installation(&places, "tables"))
        return CLI_EXIT_INPUT;
    struct tables_options options = {.runner = places.runner,
                                     .programs = places.programs,
                                     .home = places.home,
                                     .dir = a.dir,
                                     .wanted = a.tables[0] ? a.tables : NULL,
                                     .at_once = cli_jobs(a.jobs),
                                     .resume = true,
                                     .ties = a.ties,
                                     .report = a.report,
                                     .choices = a.choices,
                                     .json = a.json,
                                     .out = a.json && !strcmp(a.json, "-") ? stderr : stdout,
                                     .progress = stderr,
                                     .signal = &signal};
    enum tables_end end =
        a.explain ? tables_explain(&options, a.explain, a.json, &error) : tables_make(&options, &error);
    if (end == TABLES_ERROR)
        cli_say_error("tables", "%s", error);
    free(error);
    return end == TABLES_DONE ? 0 : end == TABLES_INCOMPLETE ? 1 : signal ? 128 + signal : CLI_EXIT_INPUT;
}
