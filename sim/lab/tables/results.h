/* results.h - the rows of the paper's tables with the outcomes of their runs, and how they are shown. */
#ifndef LAB_TABLES_RESULTS_H
#define LAB_TABLES_RESULTS_H
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#include "lab/jobs/outcome.h"
#include "lab/tables/paper_fitted.h"
#include "lab/tables/table_runs.h"

struct result_row {
    const struct paper_row *row;
    struct run *run;
};

struct result_table {
    const struct paper_table *table;
    struct result_row *rows; /* table->count of them */
};

struct results {
    const struct paper *paper;
    const struct paper_fitted *fitted;
    struct result_table *tables; /* the wanted tables */
    size_t table_count;
    struct run *runs;
    size_t run_count;
    double wall_time_s;
    size_t printed; /* tables that results_print_ready() has printed */
};

/* The rows of the wanted tables (numbers ended by 0; NULL: all), each with its run, which has not been run
 * yet. paper and fitted must outlive the results. */
struct results results_plan(const struct paper *paper, const struct paper_fitted *fitted,
                            const unsigned *wanted);
void results_free(struct results *r);

/* The error of the row's total time against the paper's, percent; NAN if the row has no time. */
double results_error_pct(const struct result_row *row);
/* The table's row of one node; NULL if there is none. */
const struct result_row *results_one_node(const struct result_table *t);
/* T(1) / (N T(N)) of the simulated times; NAN if either is missing. */
double results_speed_per_node(const struct result_table *t, size_t row);

/* Mean and worst of rows' errors. Failed rows only count as failed. */
struct result_errors {
    size_t rows, failed;
    double mean_pct;                /* mean of the errors' absolute values; NAN without rows */
    double worst_pct;               /* with its sign */
    const struct result_row *worst; /* NULL without rows */
    unsigned worst_table;
};
struct result_errors results_table_errors(const struct result_table *t);
/* Of all rows. */
struct result_errors results_row_errors(const struct results *r);
/* Of all runs: a run that several rows share counts once. */
struct result_errors results_all_errors(const struct results *r);
/* Of the runs that something was fitted to (true), or of the predicted runs (false). */
struct result_errors results_fitted_errors(const struct results *r, bool fitted);
/* Of all runs, with each table's times scaled so that its row of one node is exact. A table without such a
 * row does not count. */
struct result_errors results_scaled_errors(const struct results *r);
/* Half a unit of the last digit of the paper's total time, percent; NAN if not known. */
double results_rounding_pct(const struct result_row *row);
/* By how much the total time that the paper's speed implies differs from the paper's total time, percent; NAN
 * if there is none. */
double results_contradiction_pct(const struct result_table *t, size_t row);

/* The tables as text for people: those whose runs, and those of the tables before, have ended; then, at the
 * end, what has not been printed and what is true of all. */
void results_print_ready(struct results *r, FILE *out);
void results_print(const struct results *r, FILE *out);
/* As JSON, owned by the caller. */
json_t *results_json(const struct results *r);
/* Writes a gnuplot script that draws table t into DIR/table-N.png and .svg. */
void results_plot(const struct result_table *t, const char *dir, FILE *script);
#endif
