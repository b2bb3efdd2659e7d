/* results.c - errors and speeds of the tables' rows; see results.h. */
#include "lab/tables/results.h"

#include <math.h>

double results_error_pct(const struct result_row *row)
{
    return 100 * (outcome_figure(&row->run->outcome, "total_s") / row->row->paper.total_s - 1);
}

const struct result_row *results_one_node(const struct result_table *t)
{
    for (size_t i = 0; i < t->table->count; i++)
        if (t->rows[i].run->nodes == 1)
            return &t->rows[i];
    return NULL;
}

double results_speed_per_node(const struct result_table *t, size_t row)
{
    const struct run *run = t->rows[row].run;
    const struct result_row *one = results_one_node(t);
    return one ? outcome_figure(&one->run->outcome, "total_s") /
                     (run->nodes * outcome_figure(&run->outcome, "total_s"))
               : NAN;
}

/* Adds an error to e. Until finish(), mean_pct is a sum. */
static void add_error(struct result_errors *e, const struct result_row *row, unsigned table, double error)
{
    if (isnan(error)) {
        e->failed++;
        return;
    }
    if (!e->worst || fabs(error) > fabs(e->worst_pct)) {
        e->worst = row;
        e->worst_pct = error;
        e->worst_table = table;
    }
    e->mean_pct += fabs(error);
    e->rows++;
}

static void add(struct result_errors *e, const struct result_row *row, unsigned table)
{
    add_error(e, row, table, results_error_pct(row));
}

static struct result_errors finish(struct result_errors e)
{
    e.mean_pct = e.rows ? e.mean_pct / (double)e.rows : NAN;
    e.worst_pct = e.rows ? e.worst_pct : NAN;
    return e;
}

struct result_errors results_table_errors(const struct result_table *t)
{
    struct result_errors e = {0};
    for (size_t i = 0; i < t->table->count; i++)
        add(&e, &t->rows[i], t->table->number);
    return finish(e);
}

/* Is the run that of a row of an earlier table? */
static bool shown_before(const struct results *r, size_t table, const struct run *run)
{
    for (size_t t = 0; t < table; t++)
        for (size_t i = 0; i < r->tables[t].table->count; i++)
            if (r->tables[t].rows[i].run == run)
                return true;
    return false;
}

static struct result_errors errors_of(const struct results *r, bool fitted, bool others)
{
    struct result_errors e = {0};
    for (size_t t = 0; t < r->table_count; t++)
        for (size_t i = 0; i < r->tables[t].table->count; i++) {
            const struct run *run = r->tables[t].rows[i].run;
            if ((run->fitted ? fitted : others) && !shown_before(r, t, run))
                add(&e, &r->tables[t].rows[i], r->tables[t].table->number);
        }
    return finish(e);
}

struct result_errors results_row_errors(const struct results *r)
{
    struct result_errors e = {0};
    for (size_t t = 0; t < r->table_count; t++)
        for (size_t i = 0; i < r->tables[t].table->count; i++)
            add(&e, &r->tables[t].rows[i], r->tables[t].table->number);
    return finish(e);
}

struct result_errors results_all_errors(const struct results *r)
{
    return errors_of(r, true, true);
}

struct result_errors results_fitted_errors(const struct results *r, bool fitted)
{
    return errors_of(r, fitted, !fitted);
}

struct result_errors results_scaled_errors(const struct results *r)
{
    struct result_errors e = {0};
    for (size_t t = 0; t < r->table_count; t++) {
        const struct result_table *table = &r->tables[t];
        const struct result_row *one = results_one_node(table);
        double scale = one ? 1 + results_error_pct(one) / 100 : NAN;
        for (size_t i = 0; one && i < table->table->count; i++)
            if (!shown_before(r, t, table->rows[i].run))
                add_error(&e, &table->rows[i], table->table->number,
                          100 * ((1 + results_error_pct(&table->rows[i]) / 100) / scale - 1));
    }
    return finish(e);
}

double results_rounding_pct(const struct result_row *row)
{
    return 100 * row->row->paper.total_unit_s / 2 / row->row->paper.total_s;
}

double results_contradiction_pct(const struct result_table *t, size_t row)
{
    const struct paper_row *r = &t->table->rows[row];
    for (size_t i = 0; i < t->table->count; i++)
        if (t->table->rows[i].nodes == 1)
            return 100 * (t->table->rows[i].paper.total_s / (r->nodes * r->paper.speed_per_node) /
                              r->paper.total_s -
                          1);
    return NAN;
}
