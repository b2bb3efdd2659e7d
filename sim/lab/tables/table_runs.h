/* table_runs.h - runs the paper's program for rows of the tables, as child processes "RUNNER run ...". */
#ifndef LAB_TABLES_TABLE_RUNS_H
#define LAB_TABLES_TABLE_RUNS_H
#include <stdbool.h>
#include <stddef.h>

#include "lab/jobs/outcome.h"
#include "lab/tables/paper.h"

/* One run, which several rows may share. */
struct run {
    unsigned nodes;
    const char *arguments; /* of its first row */
    const char *extra;     /* further arguments, separated by spaces; or NULL */
    char **settings;       /* for --set: words.h */
    char *name;            /* "tables 1, 2, 3; 8 nodes"; malloc'd */
    unsigned turn;         /* of its first table: earlier tables' runs start first */
    double weight;         /* its host time in any unit */
    bool fitted;           /* something was fitted to one of its rows */
    struct outcome outcome;
    bool ties;         /* its time is sensitive to ties (tie_sensitivity.h) */
    unsigned tie_runs; /* runs with small changes of the machine: their number, shortest and longest time */
    double tie_least_s, tie_most_s;
};

struct tables_options;

/* Is called whenever outcomes have been set. May be {NULL}. */
struct runs_watcher {
    void (*changed)(void *arg);
    void *arg;
};

/* Runs all of them, or takes them from the journal, and sets their outcomes. Adds the host time to *wall_s.
 * False with *error malloc'd if a signal stopped the runs. */
bool table_runs_do(const struct tables_options *o, const struct paper *paper, struct run runs[], size_t count,
                   struct runs_watcher watcher, double *wall_s, char **error);
void table_runs_clear(struct run runs[], size_t count);
#endif
