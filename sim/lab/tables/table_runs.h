/* table_runs.h - runs of the program on the simulator, as child processes "RUNNER run ...", through the pool. */
#ifndef LAB_TABLES_TABLE_RUNS_H
#define LAB_TABLES_TABLE_RUNS_H
#include <stdbool.h>
#include <stddef.h>

#include "lab/jobs/outcome.h"
#include "lab/tables/paper.h"

enum { RUN_MAX_SETTINGS = 8, RUN_MAX_EXTRA = 8 };

/* One run; several rows of the tables may be the same one. */
struct run {
    unsigned nodes;
    const char *arguments;                /* of its first row */
    const char *extra;                    /* more arguments after these, separated by spaces, or NULL */
    char *settings[RUN_MAX_SETTINGS + 1]; /* of the machine file (--set), ended by NULL; malloc'd */
    char *name;                           /* "tables 1, 2, 3; 8 nodes"; malloc'd */
    double weight;                        /* its share of the work */
    bool fitted;                          /* constants were fitted to one of its rows */
    struct outcome outcome;
    bool ties; /* what happens in it turns on ties (tie_sensitivity.c) */
    unsigned
        tie_runs; /* the same with small changes of the machine: how many, and the least and longest time */
    double tie_least_s, tie_most_s;
};

struct tables_options;

/* Does all of them and sets their outcomes; false when a signal stopped it. Adds the real time taken to *wall_s. */
bool table_runs_do(const struct tables_options *o, const struct paper *paper, struct run runs[], size_t count,
                   double *wall_s, char **error);
void table_runs_clear(struct run runs[], size_t count);
#endif
