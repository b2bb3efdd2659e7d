/* choices.c - see choices.h. */
#include "lab/tables/choices.h"
#include "files/atomic_file.h"
#include "kernel/xalloc.h"
#include "files/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char HEAD[] =
    "# What each choice does to the tables\n"
    "\n"
    "Written by `make choices` (`touchstone tables --choices FILE`) from runs of all rows; do not edit.\n"
    "\n"
    "Each constant and policy of fitted.cfg was chosen with the paper's tables in view. A line changes\n"
    "one of them and nothing else, without fitting again, and gives the errors of the total times over\n"
    "all rows, each run counted once. Scaled: the times of each table are multiplied by the number that\n"
    "makes its row of one node exact, which is nearly what fitting the cost of a subcube again would\n"
    "do. Polygons: the totals of Tables 1 to 4 / Table 5; the paper's are 121486 / 78741.\n"
    "\n"
    "| choice | instead | mean, % | worst, % | scaled: mean, % | worst, % | polygons |\n"
    "|---|---|--:|---|--:|---|---|\n";

static void error_cells(FILE *out, const struct result_errors *e)
{
    if (e->rows)
        fprintf(out, " %.2f | %+.2f (%u:%u) |", e->mean_pct, e->worst_pct, e->worst_table,
                e->worst->row->nodes);
    else
        fputs(" - | - |", out);
}

/* Writes the polygons of the tables' rows of one node; equal numbers in a row once. */
static void polygons_cell(FILE *out, const struct results *r)
{
    double last = NAN;
    for (size_t t = 0; t < r->table_count; t++) {
        const struct result_row *one = results_one_node(&r->tables[t]);
        double polygons = one ? outcome_figure(&one->run->outcome, "polygons") : NAN;
        if (isnan(polygons) || polygons == last)
            continue;
        fprintf(out, "%s %.0f", isnan(last) ? "" : " /", polygons);
        last = polygons;
    }
    fputs(" |", out);
}

static void line(FILE *out, const char *what, const char *instead, const struct results *r)
{
    struct result_errors all = results_all_errors(r), scaled = results_scaled_errors(r);
    fprintf(out, "| %s | %s%s |", what, instead, all.failed ? " (rows failed)" : "");
    error_cells(out, &all);
    error_cells(out, &scaled);
    polygons_cell(out, r);
    fputc('\n', out);
}

/* Adds `instead` to each run: to the arguments, or to the machine's settings. */
static void change(struct results *v, const char *instead)
{
    static const char set[] = "--set ";
    bool machine = strncmp(instead, set, strlen(set)) == 0;
    for (size_t i = 0; i < v->run_count; i++) {
        struct run *run = &v->runs[i];
        char *name = xasprintf("%s; %s", run->name, instead);
        free(run->name);
        run->name = name;
        if (machine)
            words_add(&run->settings, xstrdup(instead + strlen(set)));
        else
            run->extra = instead;
    }
}

static bool write_instead(FILE *out, const struct tables_options *o, const struct results *r,
                          const char *what, const char *instead, char **error)
{
    struct results v = results_plan(r->paper, r->fitted, o->wanted);
    change(&v, instead);
    bool ok =
        table_runs_do(o, v.paper, v.runs, v.run_count, (struct runs_watcher){NULL}, &v.wall_time_s, error);
    char *code = xasprintf("`%s`", instead);
    if (ok)
        line(out, what, code, &v);
    free(code);
    results_free(&v);
    return ok;
}

static bool write_choice(FILE *out, const struct tables_options *o, const struct results *r,
                         const struct paper_choice *c, char **error)
{
    for (size_t i = 0; i < c->instead_count; i++)
        if (!write_instead(out, o, r, i ? "" : c->what, c->instead[i], error))
            return false;
    if (!c->instead_count)
        fprintf(out, "| %s | not tried | | | | | |\n", c->what);
    return true;
}

bool choices_write(const struct tables_options *o, const struct results *r, const char *path, char **error)
{
    struct atomic_file f;
    bool ok = atomic_file_begin(&f, path, error);
    if (!ok)
        return false;
    fputs(HEAD, f.out);
    line(f.out, "nothing changed", "", r);
    for (size_t i = 0; ok && i < r->fitted->choice_count; i++)
        ok = write_choice(f.out, o, r, &r->fitted->choices[i], error);
    if (ok)
        return atomic_file_end(&f, error);
    atomic_file_drop(&f);
    return false;
}
