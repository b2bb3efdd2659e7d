/* results.h - the rows of the paper's tables with their outcomes, and the forms in which they are shown.
 * Internal to the making of tables (tables.h). */
#ifndef LAB_TABLES_RESULTS_H
#define LAB_TABLES_RESULTS_H
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#include "lab/jobs/outcome.h"
#include "lab/tables/paper.h"
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
    struct result_table *tables; /* those wanted */
    size_t table_count;
    struct run *runs;
    size_t run_count;
    double wall_time_s;
};

/* The rows of the wanted tables (numbers ended by 0; NULL: all), each with its run; nothing has been run. Refers to
 * paper and fitted, which must outlive it. */
struct results results_plan(const struct paper *paper, const struct paper_fitted *fitted,
                            const unsigned *wanted);
void results_free(struct results *r);

/* Total time of the row against the paper's, percent; NAN if the row has none. */
double results_error_pct(const struct result_row *row);
/* The table's row of one node; NULL none. */
const struct result_row *results_one_node(const struct result_table *t);
/* T(1) / (N T(N)) of our own times; NAN if either is missing. */
double results_speed_per_node(const struct result_table *t, size_t row);

/* Mean and worst of the rows' errors. Rows that failed are counted apart. */
struct result_errors {
    size_t rows, failed;
    double mean_pct;                /* of the errors' sizes; NAN without rows */
    double worst_pct;               /* with its sign */
    const struct result_row *worst; /* NULL without rows */
    unsigned worst_table;
};
struct result_errors results_table_errors(const struct result_table *t);
struct result_errors results_row_errors(const struct results *r); /* of all rows, as the tables print them */
/* Of all rows, a run that several tables share counted once; and of those that something was fitted to, and the others.
 */
struct result_errors results_all_errors(const struct results *r);
struct result_errors results_fitted_errors(const struct results *r, bool fitted);
/* Of all runs, each once, when each table's times are scaled so that its row of one node is exact; a table without that
 * row has no part in it. */
struct result_errors results_scaled_errors(const struct results *r);
/* Half a unit of the last digit of the paper's total, percent; NAN: not known. */
double results_rounding_pct(const struct result_row *row);
/* The total that the paper's column of speeds implies, against the column of totals, percent; NAN: none. */
double results_contradiction_pct(const struct result_table *t, size_t row);

/* As many decimals as make four significant figures of a time. */
int results_decimals(double total_s);

/* Wide text for people, JSON, and Markdown (tables_report.c). */
void results_print(const struct results *r, FILE *out);
json_t *results_json(const struct results *r);
/* A gnuplot script that draws table t into DIR/table-N.png and .svg. */
void results_plot(const struct result_table *t, const char *dir, FILE *script);
#endif
