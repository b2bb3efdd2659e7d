/* tables.c - see tables.h. */
#include "lab/tables/tables.h"
#include "files/folder_make.h"
#include "files/json_write.h"
#include "kernel/xalloc.h"
#include "lab/chart/chart.h"
#include "lab/jobs/process_pool.h"
#include "lab/tables/choices.h"
#include "lab/tables/explain_json.h"
#include "lab/tables/explain_print.h"
#include "lab/tables/paper_read.h"
#include "lab/tables/results.h"
#include "lab/tables/tables_report.h"
#include "lab/tables/tie_sensitivity.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* --- writing the results -------------------------------------------------------------------------------- */

static bool write_json(const struct results *r, const char *dir, char **error)
{
    char *path = xasprintf("%s/tables.json", dir);
    bool ok = json_write(results_json(r), path, JSON_READABLE_DIGITS, error);
    free(path);
    return ok;
}

static bool write_all_json(const struct tables_options *o, const struct results *r, char **error)
{
    return write_json(r, o->dir, error) &&
           (!o->json || json_write(results_json(r), o->json, JSON_READABLE_DIGITS, error));
}

/* Draws a picture for each table. A failure is printed on progress. */
static bool draw(const struct tables_options *o, const struct results *r)
{
    char *error = NULL;
    bool ok = chart_can_draw(&error);
    if (!ok) {
        fprintf(o->progress, "no pictures: %s\n", error);
        free(error);
        return false;
    }
    for (size_t t = 0; t < r->table_count; t++) {
        char *path = xasprintf("%s/plot.%ld", o->dir, (long)getpid());
        FILE *script = fopen(path, "we");
        if (script) {
            results_plot(&r->tables[t], o->dir, script);
            fclose(script);
        }
        char *const argv[] = {"gnuplot", path, NULL};
        struct pool_job job = {.name = "the picture", .argv = argv};
        if (!script || !pool_run(&job, 1, 1, NULL).all_done) {
            fprintf(o->progress, "no picture of table %u: %s\n", r->tables[t].table->number,
                    job.error ? job.error : "no room for its script");
            ok = false;
        }
        pool_clear(&job, 1);
        unlink(path);
        free(path);
    }
    return ok;
}

static enum tables_end write_down(const struct tables_options *o, struct results *r, char **error)
{
    results_print(r, o->out);
    if (!write_all_json(o, r, error))
        return TABLES_ERROR;
    bool drawn = draw(o, r);
    fprintf(o->out, "%s/tables.json has all figures; the pictures are %s/table-N.png and .svg\n", o->dir,
            o->dir);
    if (o->report && !tables_report_write(o, r, o->report, error))
        return TABLES_ERROR;
    if (o->report)
        fprintf(o->out, "%s is the report\n", o->report);
    if (o->choices && !choices_write(o, r, o->choices, error))
        return TABLES_ERROR;
    if (o->choices)
        fprintf(o->out, "%s says what each choice does\n", o->choices);
    return drawn && results_all_errors(r).failed == 0 ? TABLES_DONE : TABLES_INCOMPLETE;
}

/* --- the whole ------------------------------------------------------------------------------------------ */

/* Removes the journal once all rows are complete: the next command runs them again. */
static enum tables_end end_journal(const struct tables_options *o, enum tables_end end)
{
    static const char *const files[] = {"journal", "lock"};
    for (size_t i = 0; o->resume && end == TABLES_DONE && i < sizeof files / sizeof *files; i++) {
        char *path = xasprintf("%s/%s", o->dir, files[i]);
        unlink(path);
        free(path);
    }
    return end;
}

struct printing {
    struct results *results;
    FILE *out;
};

static void print_ready(void *arg)
{
    struct printing *p = arg;
    results_print_ready(p->results, p->out);
}

/* The first number of those wanted that no table has; 0 if there is none. */
static unsigned not_there(const unsigned *wanted, const struct paper *paper)
{
    for (; wanted && *wanted; wanted++) {
        size_t t = 0;
        while (t < paper->count && paper->tables[t].number != *wanted)
            t++;
        if (t == paper->count)
            return *wanted;
    }
    return 0;
}

static enum tables_end make(const struct tables_options *o, struct results *r, char **error)
{
    struct printing printing = {r, o->out};
    /* (The range of a row that is sensitive to ties is known last.) */
    struct runs_watcher watcher = {o->ties ? NULL : print_ready, &printing};
    unsigned unknown = not_there(o->wanted, r->paper);
    if (unknown)
        *error = xasprintf("the paper has no Table %u: its tables are %u to %u", unknown,
                           r->paper->tables[0].number, r->paper->tables[r->paper->count - 1].number);
    else if (!folder_make(o->dir))
        *error = xasprintf("%s cannot be made: %s", o->dir, strerror(errno));
    else if (table_runs_do(o, r->paper, r->runs, r->run_count, watcher, &r->wall_time_s, error) &&
             (!o->ties || tie_sensitivity_run(o, r, error)))
        return end_journal(o, write_down(o, r, error));
    return TABLES_ERROR;
}

static struct paper *read_rows(const struct tables_options *o, char **error)
{
    char *path = xasprintf("%s/bench/paper/paper.cfg", o->home);
    struct paper *paper = paper_read(path, error);
    free(path);
    return paper;
}

enum tables_end tables_make(const struct tables_options *o, char **error)
{
    char *fitted_path = xasprintf("%s/bench/paper/fitted.cfg", o->home);
    enum tables_end end = TABLES_ERROR;
    struct paper *paper = read_rows(o, error);
    struct paper_fitted *fitted = paper ? paper_read_fitted(fitted_path, error) : NULL;
    if (fitted) {
        struct results r = results_plan(paper, fitted, o->wanted);
        end = make(o, &r, error);
        results_free(&r);
    }
    paper_free_fitted(fitted);
    paper_free(paper);
    free(fitted_path);
    return end;
}

static struct explain *run_and_explain(const struct tables_options *o, const struct paper *paper,
                                       const struct paper_row *row, unsigned table, char **error)
{
    double wall_s = 0;
    struct explain *e = NULL;
    struct run runs[] = {
        {.nodes = row->nodes, .arguments = row->arguments, .weight = 1, .name = xasprintf("the row")},
        {.nodes = row->nodes,
         .arguments = row->arguments,
         .extra = "-times",
         .weight = 1,
         .name = xasprintf("the row, measured")}};
    struct tables_options alone = *o;
    alone.resume = false;
    if (table_runs_do(&alone, paper, runs, 2, (struct runs_watcher){NULL}, &wall_s, error))
        e = explain_read(paper, row, table, &runs[1].outcome, &runs[0].outcome, error);
    table_runs_clear(runs, 2);
    return e;
}

enum tables_end tables_explain(const struct tables_options *o, const char *name, const char *json,
                               char **error)
{
    struct paper *paper = read_rows(o, error);
    unsigned table = 0, nodes;
    if (!paper)
        return TABLES_ERROR;
    const struct paper_row *row = paper_find(paper, name);
    struct explain *e = NULL;
    if (row && paper_row_name(name, &table, &nodes))
        e = run_and_explain(o, paper, row, table, error);
    else
        *error = xasprintf("no row %s in the tables; rows are table:nodes, such as 1:128", name);
    bool ok = e && (!json || json_write(explain_json(e), json, JSON_READABLE_DIGITS, error));
    if (e && !json)
        explain_print(e, o->out);
    explain_free(e);
    paper_free(paper);
    return ok ? TABLES_DONE : TABLES_ERROR;
}
