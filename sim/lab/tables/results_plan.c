/* results_plan.c - finds the runs of the rows: rows with equal nodes and arguments share one; see
 * results.h. */
#include "kernel/xalloc.h"
#include "lab/tables/results.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool is_wanted(unsigned number, const unsigned *wanted)
{
    for (size_t i = 0; wanted && wanted[i]; i++)
        if (wanted[i] == number)
            return true;
    return !wanted;
}

/* The run's weight: the computing time of all nodes by the paper's figures, to which the host time is about
 * proportional. */
static double weight_of(const struct paper_row *row)
{
    double idle = isnan(row->paper.slave_idle_pct) ? 0 : row->paper.slave_idle_pct / 100;
    return row->nodes * row->paper.total_s * (1 - idle);
}

/* The run of that row: an earlier row's, or a new one. */
static struct run *run_for(struct results *r, const struct paper_row *row)
{
    for (size_t i = 0; i < r->run_count; i++)
        if (r->runs[i].nodes == row->nodes && strcmp(r->runs[i].arguments, row->arguments) == 0)
            return &r->runs[i];
    struct run *run = &r->runs[r->run_count++];
    *run = (struct run){.nodes = row->nodes,
                        .arguments = row->arguments,
                        .turn = (unsigned)r->table_count,
                        .weight = weight_of(row)};
    return run;
}

/* Names the run: "tables 1, 2, 3; 8 nodes". */
static void name_run(const struct results *r, struct run *run)
{
    char list[64] = "";
    size_t used = 0, shared = 0;
    for (size_t t = 0; t < r->table_count; t++)
        for (size_t i = 0; i < r->tables[t].table->count; i++)
            if (r->tables[t].rows[i].run == run && used < sizeof list)
                used += (size_t)snprintf(list + used, sizeof list - used, "%s%u", shared++ ? ", " : "",
                                         r->tables[t].table->number);
    run->name = xasprintf("table%s %s; %u node%s", shared > 1 ? "s" : "", list, run->nodes,
                          run->nodes == 1 ? "" : "s");
}

struct results results_plan(const struct paper *paper, const struct paper_fitted *fitted,
                            const unsigned *wanted)
{
    struct results r = {.paper = paper, .fitted = fitted};
    size_t rows = 0;
    for (size_t t = 0; t < paper->count; t++)
        rows += paper->tables[t].count;
    r.tables = xcalloc(paper->count, sizeof *r.tables);
    r.runs = xcalloc(rows, sizeof *r.runs);
    for (size_t t = 0; t < paper->count; t++) {
        const struct paper_table *table = &paper->tables[t];
        if (!is_wanted(table->number, wanted))
            continue;
        struct result_table *result = &r.tables[r.table_count++];
        *result = (struct result_table){table, xcalloc(table->count, sizeof *result->rows)};
        for (size_t i = 0; i < table->count; i++) {
            result->rows[i] = (struct result_row){&table->rows[i], run_for(&r, &table->rows[i])};
            result->rows[i].run->fitted |= table->rows[i].fitted;
            result->rows[i].run->ties |= table->rows[i].ties;
        }
    }
    for (size_t i = 0; i < r.run_count; i++)
        name_run(&r, &r.runs[i]);
    return r;
}

void results_free(struct results *r)
{
    for (size_t t = 0; t < r->table_count; t++)
        free(r->tables[t].rows);
    table_runs_clear(r->runs, r->run_count);
    free(r->tables);
    free(r->runs);
}
