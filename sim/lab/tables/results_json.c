/* results_json.c - the tables as JSON; see results.h. Two runs of one program differ only in members whose
 * name contains "wall_time". */
#include "files/json_set.h"
#include "lab/tables/results.h"

#include <stdlib.h>
#include <string.h>

/* Adds members of `from` that `to` lacks: all, or those named in `only`, ended by NULL. */
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
            json_set(to, key, json_incref(value));
    }
}

/* The computing time of all nodes. */
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
    json_set(j, "table", json_integer(t->table->number));
    json_set(j, "nodes", json_integer(row->row->nodes));
    json_set(j, "arguments", json_string_or_null(row->row->arguments));
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
        json_set(j, keys[k], json_real_or_null(outcome_figure(o, keys[k])));
    json_set(j, "speed_per_node", json_real_or_null(results_speed_per_node(t, i)));
    json_set(j, "error_pct", json_real_or_null(results_error_pct(row)));
    json_set(j, "paper_total_s", json_real_or_null(paper->total_s));
    json_set(j, "paper_host_idle_pct", json_real_or_null(paper->host_idle_pct));
    json_set(j, "paper_slave_idle_pct", json_real_or_null(paper->slave_idle_pct));
    json_set(j, "paper_slave_idle_spread_pct", json_real_or_null(paper->slave_idle_spread_pct));
    json_set(j, "paper_speed_per_node", json_real_or_null(paper->speed_per_node));
    json_set(j, "fitted", json_boolean(row->run->fitted));
    json_set(j, "paper_rounding_pct", json_real_or_null(results_rounding_pct(row)));
    json_set(j, "paper_contradiction_pct", json_real_or_null(results_contradiction_pct(t, i)));
    if (row->run->tie_runs) {
        json_set(j, "tie_runs", json_integer(row->run->tie_runs));
        json_set(j, "tie_least_s", json_real_or_null(row->run->tie_least_s));
        json_set(j, "tie_most_s", json_real_or_null(row->run->tie_most_s));
    }
    json_set(j, "failure", json_string_or_null(o->error));
    if (!o->error) {
        json_set(j, "wall_time_s", json_real(o->wall_time_s));
        add_rest(j, o->printed, NULL);
        add_rest(j, o->run, of_the_run);
        json_set(j, "computed_s", json_real_or_null(computed_s(o->run)));
    }
    return j;
}

static json_t *errors_json(const struct result_errors *e)
{
    json_t *j = json_object();
    json_set(j, "rows", json_integer((json_int_t)e->rows));
    json_set(j, "failed", json_integer((json_int_t)e->failed));
    json_set(j, "mean_error_pct", json_real_or_null(e->mean_pct));
    json_set(j, "worst_error_pct", json_real_or_null(e->worst_pct));
    json_set(j, "worst_table", e->worst ? json_integer(e->worst_table) : json_null());
    json_set(j, "worst_nodes", e->worst ? json_integer(e->worst->row->nodes) : json_null());
    return j;
}

static json_t *fitted_json(const struct paper_fitted *fitted)
{
    json_t *list = json_array();
    for (size_t i = 0; i < fitted->count; i++) {
        const struct paper_factor *f = &fitted->factors[i];
        json_t *j = json_object();
        json_set(j, "file", json_string_or_null(f->file));
        json_set(j, "function", json_string_or_null(f->function));
        json_set(j, "factor", json_real(f->factor));
        json_set(j, "fitted_to", json_string_or_null(f->fitted_to));
        json_array_append_new(list, j);
    }
    return list;
}

static json_t *choices_json(const struct paper_fitted *fitted)
{
    json_t *list = json_array();
    for (size_t i = 0; i < fitted->choice_count; i++) {
        json_t *j = json_object();
        json_set(j, "kind", json_string_or_null(fitted->choices[i].policy ? "policy" : "constant"));
        json_set(j, "what", json_string_or_null(fitted->choices[i].what));
        json_set(j, "fitted_to", json_string_or_null(fitted->choices[i].fitted_to));
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
        json_set(j, "table", json_integer(table->table->number));
        json_set(j, "title", json_string_or_null(table->table->title));
        json_array_append_new(tables, j);
    }
    struct result_errors all = results_all_errors(r);
    json_t *summary = errors_json(&all);
    struct result_errors fitted = results_fitted_errors(r, true), others = results_fitted_errors(r, false);
    struct result_errors as_printed = results_row_errors(r);
    json_set(summary, "all_rows", errors_json(&as_printed));
    json_set(summary, "fitted_rows", errors_json(&fitted));
    json_set(summary, "predicted_rows", errors_json(&others));
    json_set(summary, "tables", tables);
    json_set(summary, "wall_time_s", json_real(r->wall_time_s));
    json_set(root, "format", json_string("touchstone tables 1"));
    json_set(root, "rows", rows);
    json_set(root, "fitted", fitted_json(r->fitted));
    json_set(root, "fitted_choices", choices_json(r->fitted));
    json_set(root, "summary", summary);
    return root;
}
