/* tables.c - touchstone tables: the paper's tables, reproduced. */
#include <getopt.h>
#include <limits.h>
#include <stdlib.h>
#include <stdio.h>
#include <string.h>

#include "cli/cli.h"
#include "config/config.h"
#include "lab/tables/tables.h"

static const char HELP[] =
    "usage: touchstone tables [-t TABLES] [-o DIR] [-j JOBS] [--ties] [--report FILE] [--choices FILE]\n"
    "       touchstone tables --explain ROW [-j JOBS]\n"
    "\n"
    "Runs the model program as each row of Tables 1-5 of Bajaj & Lin, \"Scalar Field Modeling & "
    "Visualization on the\n"
    "Intel Delta\", was run, and sets its figures beside the paper's. Rows that are the same run are run "
    "once.\n"
    "\n"
    "  -t, --tables TABLES  which ones, such as 1,2; default all\n"
    "  -o, --output DIR     where the results go; default out: tables.json, and table-N.png and .svg for "
    "each table\n"
    "  -j, --jobs JOBS      how many rows to run at a time; default the number of processors\n"
    "\n"
    "      --ties           run rows in which a small change may decide what happens 8 times more, with a\n"
    "                       message's latency 2 % less to 2 % more, and give the range of their times beside\n"
    "      --report FILE    write a report in Markdown: errors, the paper's own rounding, what was fitted, what\n"
    "                       remains and where its time goes\n"
    "      --choices FILE   run all rows once more for each choice that was made with the paper's tables in view, with it\n"
    "                       otherwise, and write the errors in Markdown; about half a minute a choice\n"
    "      --explain ROW    make no tables: say where the time of one row goes, by activity, processor and layer; ROW\n"
    "                       is table:nodes, such as 1:128\n"
    "\n"
    "Rows are kept in DIR/journal until all are there: after Ctrl-C or kill -9 the same command goes on.\n"
    "\n"
    "Exit status: 0 every row is there; 1 a row or a picture failed (named, the rest is there); 64 wrong "
    "arguments;\n"
    "65 the program or the paper's figures cannot be used, or the results not written.\n";

enum { EXIT_USAGE = 64, EXIT_INPUT = 65, MAX_TABLES = 16 };

struct arguments {
    unsigned tables[MAX_TABLES + 1]; /* ended by 0; none: all */
    const char *dir, *report, *choices, *explain;
    unsigned jobs;
    bool ties, help;
};

/* "1,2" */
static bool read_tables(const char *text, unsigned tables[])
{
    for (int n = 0; n < MAX_TABLES; n++) {
        char *end;
        long number = strtol(text, &end, 10);
        if (end == text || number < 1 || number > 99 || (*end && *end != ','))
            return false;
        tables[n] = (unsigned)number;
        if (!*end)
            return true;
        text = end + 1;
    }
    return false;
}

static int parse(int argc, char **argv, struct arguments *a)
{
    enum { TIES = 256, REPORT, CHOICES, EXPLAIN };
    static const struct option LONG[] = {{"tables", required_argument, NULL, 't'},
                                         {"ties", no_argument, NULL, TIES},
                                         {"report", required_argument, NULL, REPORT},
                                         {"choices", required_argument, NULL, CHOICES},
                                         {"explain", required_argument, NULL, EXPLAIN},
                                         {"output", required_argument, NULL, 'o'},
                                         {"jobs", required_argument, NULL, 'j'},
                                         {"help", no_argument, NULL, 'h'},
                                         {0}};
    *a = (struct arguments){.dir = "out", .jobs = cli_processors()};
    optind = 0;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, "+:t:o:j:h", LONG, NULL)) != -1;) {
        switch (c) {
        case 't':
            if (!read_tables(optarg, a->tables))
                return cli_usage("tables", "-t takes numbers of tables, such as 1,2, not '%s'", optarg);
            break;
        case 'o':
            a->dir = optarg;
            break;
        case 'j':
            if (!cli_jobs(optarg, &a->jobs))
                return cli_usage("tables", "-j takes a number from 1 to %d, not '%s'", CLI_MAX_JOBS, optarg);
            break;
        case TIES:
            a->ties = true;
            break;
        case REPORT:
            a->report = optarg;
            break;
        case CHOICES:
            a->choices = optarg;
            break;
        case EXPLAIN:
            a->explain = optarg;
            break;
        case 'h':
            a->help = true;
            return 0;
        case ':':
            return cli_usage("tables", "%s needs a value", argv[optind - 1]);
        default:
            return cli_usage("tables", "there is no option %s", argv[optind - 1]);
        }
    }
    return optind == argc ? 0 : cli_usage("tables", "'%s' is one argument too many", argv[optind]);
}

int cli_tables(int argc, char **argv)
{
    struct arguments a;
    char home[PATH_MAX], runner[PATH_MAX], programs[CLI_MAX_PROGRAMS], *error = NULL;
    int wrong = parse(argc, argv, &a);
    if (wrong)
        return wrong;
    if (a.help)
        return fputs(HELP, stdout), 0;
    if (!cfg_home(home, sizeof home) || !cli_find_programs(runner, programs)) {
        fputs("touchstone tables: machines/ is not where this program was built or installed; set "
              "TOUCHSTONE_HOME\n",
              stderr);
        return EXIT_INPUT;
    }
    struct tables_options options = {.runner = runner,
                                     .programs = programs,
                                     .home = home,
                                     .dir = a.dir,
                                     .wanted = a.tables[0] ? a.tables : NULL,
                                     .at_once = a.jobs,
                                     .resume = true,
                                     .ties = a.ties,
                                     .report = a.report,
                                     .choices = a.choices,
                                     .out = stdout,
                                     .progress = stderr};
    enum tables_end end =
        a.explain ? tables_explain(&options, a.explain, &error) : tables_make(&options, &error);
    if (end == TABLES_ERROR) {
        fprintf(stderr, "touchstone tables: %s\n", error);
        free(error);
    }
    return end == TABLES_DONE ? 0 : end == TABLES_INCOMPLETE ? 1 : EXIT_INPUT;
}
