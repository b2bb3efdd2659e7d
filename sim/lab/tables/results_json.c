/* results_json.c - the tables as JSON. Only members whose name holds "wall_time" differ between two runs of one program. */
#include "lab/tables/results.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void set(json_t *object, const char *key, json_t *value)
{
    if (json_object_set_new(object, key, value) != 0)
        abort();
}

/* null where a figure does not apply. */
static json_t *figure(double value)
{
    return isnan(value) ? json_null() : json_real(value);
}

static json_t *text(const char *s)
{
    return s ? json_string(s) : json_null();
}

/* Members of `from` that `to` has not got: all of them, or those named in only (ended by NULL). */
static void add_rest(json_t *to, json_t *from, const char *const only[])
{
    const char *key;
    json_t *value;
    json_object_foreach(from, key, value)
    {
        bool wanted = !only;
        for (size_t k = 0; only && only[k]; k++)
            wanted |= strcmp(key, only[k]) == 0;
        if (wanted && !json_object_get(to, key))
            json_object_set(to, key, value);
    }
}

/* What the nodes' programs computed, together. */
static double computed_s(const json_t *run)
{
    double sum = 0;
    size_t i;
    json_t *node;
    json_array_foreach(json_object_get(run, "node"), i, node) sum += figure_of(node, "busy_s");
    return sum;
}

static json_t *row_json(const struct result_table *t, size_t i)
{
    static const char *const keys[] = {"total_s", "host_idle_pct", "host_idle_all_pct", "slave_idle_pct",
                                       "slave_idle_spread_pct"};
    static const char *const of_the_run[] = {"machine", "virtual_time_s", "messages",
                                             "bytes",   "digest",         NULL};
    const struct result_row *row = &t->rows[i];
    const struct paper_figures *paper = &row->row->paper;
    const struct outcome *o = &row->run->outcome;
    json_t *j = json_object();
    set(j, "table", json_integer(t->table->number));
    set(j, "nodes", json_integer(row->row->nodes));
    set(j, "arguments", text(row->row->arguments));
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
        set(j, keys[k], figure(outcome_figure(o, keys[k])));
    set(j, "speed_per_node", figure(results_speed_per_node(t, i)));
    set(j, "error_pct", figure(results_error_pct(row)));
    set(j, "paper_total_s", figure(paper->total_s));
    set(j, "paper_host_idle_pct", figure(paper->host_idle_pct));
    set(j, "paper_slave_idle_pct", figure(paper->slave_idle_pct));
    set(j, "paper_slave_idle_spread_pct", figure(paper->slave_idle_spread_pct));
    set(j, "paper_speed_per_node", figure(paper->speed_per_node));
    set(j, "fitted", json_boolean(row->run->fitted));
    set(j, "paper_rounding_pct", figure(results_rounding_pct(row)));
    set(j, "paper_contradiction_pct", figure(results_contradiction_pct(t, i)));
    if (row->run->tie_runs) {
        set(j, "tie_runs", json_integer(row->run->tie_runs));
        set(j, "tie_least_s", figure(row->run->tie_least_s));
        set(j, "tie_most_s", figure(row->run->tie_most_s));
    }
    set(j, "failure", text(o->error));
    if (!o->error) {
        set(j, "wall_time_s", json_real(o->wall_time_s));
        add_rest(j, o->printed, NULL);
        add_rest(j, o->run, of_the_run);
        set(j, "computed_s", figure(computed_s(o->run)));
    }
    return j;
}

static json_t *errors_json(const struct result_errors *e)
{
    json_t *j = json_object();
    set(j, "rows", json_integer((json_int_t)e->rows));
    set(j, "failed", json_integer((json_int_t)e->failed));
    set(j, "mean_error_pct", figure(e->mean_pct));
    set(j, "worst_error_pct", figure(e->worst_pct));
    set(j, "worst_table", e->worst ? json_integer(e->worst_table) : json_null());
    set(j, "worst_nodes", e->worst ? json_integer(e->worst->row->nodes) : json_null());
    return j;
}

static json_t *fitted_json(const struct paper_fitted *fitted)
{
    json_t *list = json_array();
    for (size_t i = 0; i < fitted->count; i++) {
        const struct paper_factor *f = &fitted->factors[i];
        json_t *j = json_object();
        set(j, "file", text(f->file));
        set(j, "function", text(f->function));
        set(j, "factor", json_real(f->factor));
        set(j, "fitted_to", text(f->fitted_to));
        json_array_append_new(list, j);
    }
    return list;
}

static json_t *choices_json(const struct paper_fitted *fitted)
{
    json_t *list = json_array();
    for (size_t i = 0; i < fitted->choice_count; i++) {
        json_t *j = json_object();
        set(j, "kind", text(fitted->choices[i].policy ? "policy" : "constant"));
        set(j, "what", text(fitted->choices[i].what));
        set(j, "fitted_to", text(fitted->choices[i].fitted_to));
        json_array_append_new(list, j);
    }
    return list;
}

json_t *results_json(const struct results *r)
{
    json_t *root = json_object(), *rows = json_array(), *tables = json_array();
    for (size_t t = 0; t < r->table_count; t++) {
        const struct result_table *table = &r->tables[t];
        for (size_t i = 0; i < table->table->count; i++)
            json_array_append_new(rows, row_json(table, i));
        struct result_errors e = results_table_errors(table);
        json_t *j = errors_json(&e);
        set(j, "table", json_integer(table->table->number));
        set(j, "title", text(table->table->title));
        json_array_append_new(tables, j);
    }
    struct result_errors all = results_all_errors(r);
    json_t *summary = errors_json(&all);
    struct result_errors fitted = results_fitted_errors(r, true), others = results_fitted_errors(r, false);
    struct result_errors as_printed = results_row_errors(r);
    set(summary, "all_rows", errors_json(&as_printed));
    set(summary, "fitted_rows", errors_json(&fitted));
    set(summary, "predicted_rows", errors_json(&others));
    set(summary, "tables", tables);
    set(summary, "wall_time_s", json_real(r->wall_time_s));
    set(root, "rows", rows);
    set(root, "fitted", fitted_json(r->fitted));
    set(root, "fitted_choices", choices_json(r->fitted));
    set(root, "summary", summary);
    return root;
}
