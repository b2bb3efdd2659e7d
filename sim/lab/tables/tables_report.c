/* tables_report.c - see tables_report.h. */
#include "lab/tables/tables_report.h"
#include "files/atomic_file.h"
#include "kernel/xalloc.h"
#include "lab/tables/explain_print.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LARGEST = 5 }; /* number of rows that are explained */

/* Writes a cell: the figure, "-" if there is none. */
static void cell(FILE *out, const char *format, double value)
{
    fputs(" ", out);
    if (isnan(value))
        fputs("-", out);
    else
        fprintf(out, format, value);
    fputs(" |", out);
}

/* --- accuracy ------------------------------------------------------------------------------------------- */

static void accuracy_row(FILE *out, const char *what, const struct result_errors *e)
{
    if (!e->rows)
        return;
    fprintf(out, "| %s | %zu | %.2f %% | %+.2f %% (table %u, %u node%s) |\n", what, e->rows, e->mean_pct,
            e->worst_pct, e->worst_table, e->worst->row->nodes, e->worst->row->nodes == 1 ? "" : "s");
}

/* Writes the errors between two marks, by which bench/paper/copy-accuracy copies them into README.md. */
static void write_accuracy(const struct results *r, FILE *out)
{
    fputs("<!-- accuracy: written by make report -->\n"
          "| total time | runs | mean error | worst error |\n|---|---|---|---|\n",
          out);
    for (size_t t = 0; t < r->table_count; t++) {
        struct result_errors e = results_table_errors(&r->tables[t]);
        char *name = xasprintf("Table %u", r->tables[t].table->number);
        accuracy_row(out, name, &e);
        free(name);
    }
    struct result_errors rows = results_row_errors(r), all = results_all_errors(r),
                         fitted = results_fitted_errors(r, true), others = results_fitted_errors(r, false);
    accuracy_row(out, "all rows", &rows);
    accuracy_row(out, "all, each run once", &all);
    accuracy_row(out, "of these: something was fitted to them", &fitted);
    accuracy_row(out, "of these: predictions", &others);
    fputs("<!-- accuracy ends -->\n", out);
}

/* --- the tables ----------------------------------------------------------------------------------------- */

static void range_cell(FILE *out, const struct run *run)
{
    if (run->tie_runs)
        fprintf(out, " %.4f to %.4f |", run->tie_least_s, run->tie_most_s);
    else
        cell(out, "", NAN);
}

static void table_row(FILE *out, const struct result_table *t, size_t i)
{
    const struct result_row *row = &t->rows[i];
    const struct paper_figures *paper = &row->row->paper;
    const struct outcome *o = &row->run->outcome;
    fprintf(out, "| %u |", row->row->nodes);
    cell(out, "%.3f", outcome_figure(o, "total_s"));
    range_cell(out, row->run);
    cell(out, "%g", paper->total_s);
    cell(out, "%+.2f", results_error_pct(row));
    cell(out, "%.2f", results_rounding_pct(row));
    cell(out, "%+.2f", results_contradiction_pct(t, i));
    fprintf(out, " %s |", row->run->fitted ? "fitted" : "predicted");
    cell(out, "%.1f", outcome_figure(o, "host_idle_pct"));
    cell(out, "%.1f", outcome_figure(o, "host_idle_all_pct"));
    cell(out, "%.1f", outcome_figure(o, "host_drain_pct"));
    cell(out, "%.1f", paper->host_idle_pct);
    cell(out, "%.1f", outcome_figure(o, "slave_idle_pct"));
    cell(out, "%.1f", paper->slave_idle_pct);
    cell(out, "%.1f", outcome_figure(o, "slave_idle_spread_pct"));
    cell(out, "%.1f", paper->slave_idle_spread_pct);
    fputc('\n', out);
}

static void write_table(FILE *out, const struct result_table *t)
{
    fprintf(out,
            "\n## Table %u: %s\n\n"
            "| nodes | simulated, s | range, s | paper, s | error, %% | rounding, %% | speed column, %% "
            "| standing | host idle: last, %% | all, %% | drain, %% | paper, %% | slave idle, %% | paper, %% "
            "| spread, %% | paper, %% |\n|--:|--:|--:|--:|--:|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
            t->table->number, t->table->title);
    for (size_t i = 0; i < t->table->count; i++)
        table_row(out, t, i);
}

static const char COLUMNS[] =
    "\nThe columns:\n\n"
    "- range: the shortest and longest time with a message's latency changed by -2 % to +2 %, in 8\n"
    "  steps (`--ties`), for rows in which the order of simultaneous events may decide what happens.\n"
    "- rounding: half a unit of the last digit of the paper's total time. A smaller error may be the\n"
    "  paper's rounding.\n"
    "- speed column: the total time that the paper's speed/node implies, against its total time.\n"
    "- standing: fitted, if a constant or a choice was settled by a figure of the row; otherwise\n"
    "  predicted.\n"
    "- host idle: waits for the last request of a layer, every wait for a request, and the wait for the\n"
    "  last polygons (drain), each as a part of the total time, on average over the hosts. The paper\n"
    "  defines it as waiting for a message.\n";

/* --- what was fitted ------------------------------------------------------------------------------------ */

static void write_fitted(FILE *out, const struct results *r)
{
    fputs("\n## What was fitted, or chosen with the tables in view\n\n"
          "| what | value | settled by |\n|---|---|---|\n",
          out);
    for (size_t i = 0; i < r->fitted->count; i++) {
        const struct paper_factor *f = &r->fitted->factors[i];
        fprintf(out, "| cost of %s%s%s | x %g | %s |\n", f->file ? f->file : "",
                f->file && f->function ? ", " : "", f->function ? f->function : "", f->factor, f->fitted_to);
    }
    for (size_t i = 0; i < r->fitted->choice_count; i++) {
        const struct paper_choice *c = &r->fitted->choices[i];
        fprintf(out, "| %s | %s | %s |\n", c->policy ? "policy" : "constant", c->what, c->fitted_to);
    }
    fputs("\nCHOICES.md gives the errors with each of them changed.\n", out);
}

/* --- what remains --------------------------------------------------------------------------------------- */

struct residual {
    const struct result_row *row;
    unsigned table;
};

/* Does the list have a row of that run? */
static bool is_there(const struct residual list[], size_t count, const struct run *run)
{
    for (size_t i = 0; i < count; i++)
        if (list[i].row->run == run)
            return true;
    return false;
}

/* Finds the rows of largest error beyond the paper's rounding, the largest first. Returns how many. */
static size_t find_residuals(const struct results *r, struct residual list[LARGEST])
{
    size_t count = 0;
    while (count < LARGEST) {
        struct residual largest = {0};
        double most = 0;
        for (size_t t = 0; t < r->table_count; t++)
            for (size_t i = 0; i < r->tables[t].table->count; i++) {
                const struct result_row *row = &r->tables[t].rows[i];
                double error = fabs(results_error_pct(row)), rounding = results_rounding_pct(row);
                if (!(error > most) || error <= rounding || is_there(list, count, row->run))
                    continue;
                most = error;
                largest = (struct residual){row, r->tables[t].table->number};
            }
        if (!largest.row)
            break;
        list[count++] = largest;
    }
    return count;
}

static void write_residual(FILE *out, const struct results *r, const struct residual *x,
                           const struct run *timed)
{
    const struct paper_row *row = x->row->row;
    char *error = NULL;
    fprintf(out, "\n### Table %u, %u nodes: %+.2f %%\n\n", x->table, row->nodes, results_error_pct(x->row));
    if (row->remark)
        fprintf(out, "%s\n\n", row->remark);
    struct explain *e = explain_read(r->paper, row, x->table, &timed->outcome, &x->row->run->outcome, &error);
    if (!e) {
        fprintf(out, "There is no account of its time: %s\n", error);
        free(error);
        return;
    }
    explain_markdown(e, out);
    fprintf(out, "`touchstone tables --explain %u:%u` shows every line, and each layer.\n", x->table,
            row->nodes);
    explain_free(e);
}

static bool write_residuals(FILE *out, const struct tables_options *o, struct results *r, char **error)
{
    struct residual list[LARGEST];
    struct run timed[LARGEST] = {0};
    size_t count = find_residuals(r, list);
    for (size_t i = 0; i < count; i++) {
        const struct run *run = list[i].row->run;
        timed[i] = (struct run){.nodes = run->nodes,
                                .arguments = run->arguments,
                                .extra = "-times",
                                .weight = run->weight,
                                .name = xasprintf("%s; measured", run->name)};
    }
    bool ok = table_runs_do(o, r->paper, timed, count, (struct runs_watcher){NULL}, &r->wall_time_s, error);
    if (ok && count)
        fprintf(out, "\n## What remains: the %zu largest errors\n", count);
    for (size_t i = 0; ok && i < count; i++)
        write_residual(out, r, &list[i], &timed[i]);
    table_runs_clear(timed, count);
    return ok;
}

/* --- the whole ------------------------------------------------------------------------------------------ */

static bool write_to(FILE *out, const struct tables_options *o, struct results *r, char **error)
{
    fputs("# Tables of Bajaj & Lin, simulated beside the paper's\n\n"
          "Written by `make report` (`touchstone tables --ties --report FILE`) from one run of all rows; "
          "do not edit.\n\n## How exact\n\n",
          out);
    write_accuracy(r, out);
    for (size_t t = 0; t < r->table_count; t++)
        write_table(out, &r->tables[t]);
    fputs(COLUMNS, out);
    write_fitted(out, r);
    return write_residuals(out, o, r, error);
}

bool tables_report_write(const struct tables_options *o, struct results *r, const char *path, char **error)
{
    struct atomic_file f;
    if (!atomic_file_begin(&f, path, error))
        return false;
    if (write_to(f.out, o, r, error))
        return atomic_file_end(&f, error);
    atomic_file_drop(&f);
    return false;
}
