/* tables.h - reproduces the paper's tables: runs every row and shows its figures beside the paper's.
 *
 * Each run is a child process "RUNNER run ... PROGRAM ARGS"; rows with equal nodes and arguments share one.
 * The tables are printed on `out` and written to DIR/tables.json, DIR/table-N.png and DIR/table-N.svg, and to
 * a report on demand.
 */
#ifndef LAB_TABLES_TABLES_H
#define LAB_TABLES_TABLES_H
#include <stdbool.h>
#include <stdio.h>

struct tables_options {
    const char *runner;     /* the touchstone that runs a row */
    const char *programs;   /* the folder of paper.cfg's program */
    const char *home;       /* the folder that holds bench/paper/ */
    const char *dir;        /* the folder for the results; made if missing */
    const unsigned *wanted; /* numbers of the tables, ended by 0; NULL: all */
    unsigned at_once;       /* child processes at a time */
    bool resume;            /* use DIR/journal until all rows are complete */
    bool ties;              /* compute the tie sensitivity of marked rows: tie_sensitivity.h */
    const char *report;     /* the file for the report (tables_report.h); NULL: none */
    const char *choices;    /* the file for the page of choices (choices.h); NULL: none */
    const char *json;       /* a file that gets what DIR/tables.json has; NULL: none */
    FILE *out;              /* for the tables */
    FILE *progress;         /* for progress and warnings */
    int *signal;            /* set to the signal that stopped the runs, if one did */
};

enum tables_end {
    TABLES_DONE,
    TABLES_INCOMPLETE, /* a row or a picture failed, as the text tells; the rest is complete */
    TABLES_ERROR,      /* nothing was written; *error is a malloc'd text for the user */
};
enum tables_end tables_make(const struct tables_options *options, char **error);

/* Prints on `out` where the time of one row goes (explain.h), or writes it to the file json (NULL: none), as
 * JSON. row is its table and nodes, "1:128". Writes nothing to dir. */
enum tables_end tables_explain(const struct tables_options *options, const char *row, const char *json,
                               char **error);
#endif
