/* tables.h - reproduces the paper's tables: runs every row, sets the figures beside the paper's, writes them down.
 *
 * Each different run is a child process "RUNNER run ... PROGRAM ARGS"; rows that are the same run share it. What comes
 * out: the tables as text on `out`; DIR/tables.json; DIR/table-N.png and .svg; with `report`, that too.
 */
#ifndef LAB_TABLES_TABLES_H
#define LAB_TABLES_TABLES_H
#include <stdbool.h>
#include <stdio.h>

struct tables_options {
    const char *runner;     /* the touchstone that runs a row */
    const char *programs;   /* the directory that paper.cfg's program is in */
    const char *home;       /* the directory that holds bench/paper/ */
    const char *dir;        /* for the results; made if need be */
    const unsigned *wanted; /* numbers of the tables to do, ended by 0; NULL: all */
    unsigned at_once;       /* children at a time */
    bool resume;            /* keep rows in DIR/journal until all is done, and take them from there */
    bool ties;              /* say how far rows that turn on ties depend on them: tie_sensitivity.h */
    const char *report;     /* a file for the report (tables_report.h); NULL: none */
    const char *choices;    /* a file for what each choice does (choices.h); NULL: none */
    FILE *out;              /* the tables */
    FILE *progress;         /* how it is getting on */
};

enum tables_end {
    TABLES_DONE,
    TABLES_INCOMPLETE, /* a row or a picture failed: it is named in the text, the rest is there */
    TABLES_ERROR,      /* nothing was written; *error is a malloc'd text for the user */
};
enum tables_end tables_make(const struct tables_options *options, char **error);

/* Says on `out` where the time of one row goes (explain.h); row: "1:128", table and nodes. Nothing is written to dir. */
enum tables_end tables_explain(const struct tables_options *options, const char *row, char **error);
#endif
