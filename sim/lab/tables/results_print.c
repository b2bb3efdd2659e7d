/* results_print.c - the tables as text for people, simulated figures beside the paper's; see results.h. */
#include "lab/tables/results.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "files/ink.h"

/* Prints the figure `width` characters wide, "-" if there is none. */
static void figure(FILE *out, int width, int decimals, double value)
{
    if (isnan(value))
        fprintf(out, "%*s", width, "-");
    else
        fprintf(out, "%*.*f", width, decimals, value);
}

static void pair(FILE *out, int decimals, double simulated, double papers)
{
    figure(out, 11, decimals, simulated);
    figure(out, 6, decimals, papers);
}

static void print_row(FILE *out, const struct ink *ink, const struct result_table *t, size_t i)
{
    const struct result_row *row = &t->rows[i];
    const struct paper_figures *paper = &row->row->paper;
    const struct outcome *o = &row->run->outcome;
    double error = results_error_pct(row);
    fprintf(out, "%6u", row->row->nodes);
    if (o->error) {
        fprintf(out, "%11s%9g  %sfailed%s\n", "-", paper->total_s, ink->red, ink->off);
        return;
    }
    figure(out, 11, 3, outcome_figure(o, "total_s"));
    bool none = fabs(error) < 0.05; /* which has no sign */
    fprintf(out, none ? "%9g  %s%6.1f %%%s" : "%9g  %s%+6.1f %%%s", paper->total_s,
            fabs(error) < 5 ? ink->green : ink->red, none ? 0 : error, ink->off);
    pair(out, 1, outcome_figure(o, "host_idle_pct"), paper->host_idle_pct);
    figure(out, 7, 1, outcome_figure(o, "host_idle_all_pct"));
    pair(out, 1, outcome_figure(o, "slave_idle_pct"), paper->slave_idle_pct);
    pair(out, 1, outcome_figure(o, "slave_idle_spread_pct"), paper->slave_idle_spread_pct);
    pair(out, 3, results_speed_per_node(t, i), paper->speed_per_node);
    if (row->run->tie_runs)
        fprintf(out, "  %.4f to %.4f s", row->run->tie_least_s, row->run->tie_most_s);
    fputc('\n', out);
}

static void print_errors(FILE *out, const struct result_errors *e, bool name_table)
{
    if (e->rows) {
        fprintf(out, "mean error %.2f %%, worst %+.2f %% (", e->mean_pct, e->worst_pct);
        if (name_table)
            fprintf(out, "table %u, ", e->worst_table);
        fprintf(out, "%u node%s)", e->worst->row->nodes, e->worst->row->nodes == 1 ? "" : "s");
    }
    if (e->failed)
        fprintf(out, "%s%zu failed", e->rows ? ", " : "", e->failed);
    fputc('\n', out);
}

static void print_table(FILE *out, const struct ink *ink, const struct result_table *t)
{
    fprintf(out, "\n%sTable %u: %s%s\n", ink->bold, t->table->number, t->table->title, ink->off);
    fprintf(out, "%6s%20s%10s%17s%7s%17s%17s%17s\n", "", "total time, s", "", "host idle, %", "",
            "slave idle, %", "idle spread, %", "speed/node");
    fprintf(out, "%6s%11s%9s%10s", "nodes", "simulated", "paper", "error");
    fprintf(out, "%11s%6s%7s", "simulated", "paper", "all");
    for (int i = 0; i < 3; i++)
        fprintf(out, "%11s%6s", "simulated", "paper");
    fputc('\n', out);
    for (size_t i = 0; i < t->table->count; i++)
        print_row(out, ink, t, i);
    struct result_errors e = results_table_errors(t);
    fputs("  ", out);
    print_errors(out, &e, false);
}

static void print_fitted(FILE *out, const struct ink *ink, const struct results *r)
{
    const struct paper_fitted *fitted = r->fitted;
    fprintf(out, "\n%sFitted to the paper, or chosen with its tables in view%s\n", ink->bold, ink->off);
    for (size_t i = 0; i < fitted->count; i++) {
        const struct paper_factor *f = &fitted->factors[i];
        fprintf(out, "  cost    %s%s%s x %g: %s\n", f->file ? f->file : "",
                f->file && f->function ? ", " : "", f->function ? f->function : "", f->factor, f->fitted_to);
    }
    if (!fitted->count)
        fputs("  cost    none\n", out);
    for (size_t i = 0; i < fitted->choice_count; i++)
        fprintf(out, "  %s  %s: %s\n", fitted->choices[i].policy ? "policy" : "number",
                fitted->choices[i].what, fitted->choices[i].fitted_to);
}

static bool any_ties(const struct results *r)
{
    for (size_t i = 0; i < r->run_count; i++)
        if (r->runs[i].tie_runs)
            return true;
    return false;
}

static bool is_ready(const struct result_table *t)
{
    for (size_t i = 0; i < t->table->count; i++)
        if (!t->rows[i].run->outcome.run && !t->rows[i].run->outcome.error)
            return false;
    return true;
}

void results_print_ready(struct results *r, FILE *out)
{
    struct ink ink = ink_for(out);
    for (; r->printed < r->table_count && is_ready(&r->tables[r->printed]); r->printed++)
        print_table(out, &ink, &r->tables[r->printed]);
    fflush(out);
}

void results_print(const struct results *r, FILE *out)
{
    struct ink ink = ink_for(out);
    for (size_t t = r->printed; t < r->table_count; t++)
        print_table(out, &ink, &r->tables[t]);
    fputs("\nhost idle: \"simulated\" has the waits for the last request of a layer, \"all\" has every wait "
          "for a request.\n",
          out);
    if (any_ties(r))
        fprintf(out, "range at a row's end: its times with a message's latency changed by -2 %% to +2 %%.\n");
    print_fitted(out, &ink, r);

    bool failures = false;
    for (size_t i = 0; i < r->run_count; i++) {
        if (!r->runs[i].outcome.error)
            continue;
        if (!failures)
            fprintf(out, "\n%sFailed%s\n", ink.bold, ink.off);
        failures = true;
        fprintf(out, "  %s: %s\n", r->runs[i].name, r->runs[i].outcome.error);
    }

    struct result_errors rows = results_row_errors(r), all = results_all_errors(r),
                         fitted = results_fitted_errors(r, true), others = results_fitted_errors(r, false);
    fprintf(out, "\n%sAll tables%s, %zu different runs in %.0f s: ", ink.bold, ink.off, r->run_count,
            r->wall_time_s);
    print_errors(out, &all, true);
    fprintf(out, "  all %zu rows, as printed: ", rows.rows);
    print_errors(out, &rows, true);
    fprintf(out, "  %zu runs that something was fitted to: ", fitted.rows);
    print_errors(out, &fitted, true);
    if (!others.rows && !others.failed)
        return;
    fprintf(out, "  %zu predicted: ", others.rows);
    print_errors(out, &others, true);
}
