/* paper_read.c - see paper_read.h and the head of bench/paper/paper.cfg. */
#include "lab/tables/paper_read.h"
#include "config/reader.h"
#include "files/number.h"
#include "kernel/xalloc.h"
#include "lab/study/spec.h"
#include "lab/tables/paper_notes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_NODES = SPEC_MAX_NODES, MAX_TABLE = 99 };

/* How all rows of a table are run. */
struct recipe {
    uint64_t group;
    const char *arguments, *several_groups;
};

/* Reads a column of a row: a number, a number as printed, in quotes (sets *unit to one in its last digit,
 * otherwise to NAN), or "-" for none. */
static bool read_figure(struct cfg_reader *r, config_setting_t *row, unsigned column, double *out,
                        double *unit)
{
    double ignored;
    static const char *const names[] = {"nodes", "total_s", "host_idle", "slave_idle", "spread", "speed"};
    config_setting_t *s = config_setting_get_elem(row, column);
    if (!s)
        return cfg_fail(r, row, names[column],
                        "missing; a row is ( nodes, total_s, host_idle, slave_idle, spread, speed )");
    int type = config_setting_type(s);
    *out = *(unit ? unit : &ignored) = NAN;
    if (type == CONFIG_TYPE_STRING && strcmp(config_setting_get_string(s), "-") == 0)
        return true;
    if (type == CONFIG_TYPE_STRING && !number_read(config_setting_get_string(s), out, unit ? unit : &ignored))
        *out = NAN;
    if (type == CONFIG_TYPE_FLOAT)
        *out = config_setting_get_float(s);
    else if (type == CONFIG_TYPE_INT)
        *out = config_setting_get_int(s);
    return *out >= 0 || cfg_fail(r, s, names[column], "must be a number from 0 up, or \"-\" for none");
}

static bool read_row(struct cfg_reader *r, config_setting_t *s, const struct recipe *recipe,
                     struct paper_row *row)
{
    double nodes = NAN;
    struct paper_figures *f = &row->paper;
    if (!config_setting_is_list(s))
        return cfg_fail(r, s, "rows", "must hold lists: ( nodes, total_s, ... )");
    if (!read_figure(r, s, 0, &nodes, NULL) || !read_figure(r, s, 1, &f->total_s, &f->total_unit_s) ||
        !read_figure(r, s, 2, &f->host_idle_pct, NULL) || !read_figure(r, s, 3, &f->slave_idle_pct, NULL) ||
        !read_figure(r, s, 4, &f->slave_idle_spread_pct, NULL) ||
        !read_figure(r, s, 5, &f->speed_per_node, NULL))
        return false;
    if (!(nodes >= 1 && nodes <= MAX_NODES && nodes == floor(nodes)))
        return cfg_fail(r, s, "nodes", "must be a whole number from 1 to %d", MAX_NODES);
    if (!(f->total_s > 0))
        return cfg_fail(r, s, "total_s", "must be a number above 0");
    row->nodes = (unsigned)nodes;
    row->group = recipe->group && recipe->group < row->nodes ? (unsigned)recipe->group : row->nodes;
    const char *several = row->nodes > row->group ? recipe->several_groups : "";
    row->arguments =
        xasprintf("%s -group %u%s%s", recipe->arguments, row->group, *several ? " " : "", several);
    return true;
}

static bool read_table(struct cfg_reader *r, config_setting_t *g, struct paper_table *t)
{
    static const char *const keys[] = {"table",          "title", "group", "arguments",
                                       "several_groups", "rows",  NULL};
    struct recipe recipe;
    const char *title;
    uint64_t number;
    config_setting_t *rows;
    if (!config_setting_is_group(g))
        return cfg_fail(r, g, "tables", "must hold groups: { table = 1; ... }");
    if (!cfg_only(r, g, keys) || !cfg_whole(r, g, "table", 1, MAX_TABLE, &number) ||
        !cfg_text(r, g, "title", &title) || !cfg_whole(r, g, "group", 0, MAX_NODES, &recipe.group) ||
        !cfg_text(r, g, "arguments", &recipe.arguments) || !cfg_list(r, g, "rows", &rows))
        return false;
    if (config_setting_lookup_string(g, "several_groups", &recipe.several_groups) != CONFIG_TRUE)
        recipe.several_groups = "";
    t->number = (unsigned)number;
    t->title = xstrdup(title);
    t->count = (size_t)config_setting_length(rows);
    t->rows = xcalloc(t->count, sizeof *t->rows);
    for (unsigned i = 0; i < t->count; i++)
        if (!read_row(r, config_setting_get_elem(rows, i), &recipe, &t->rows[i]))
            return false;
    return true;
}

static bool read_paper(struct cfg_reader *r, struct paper *p)
{
    static const char *const keys[] = {"machine",  "program", "tables",   "fitted_rows",
                                       "tie_rows", "remarks", "messages", NULL};
    const char *machine, *program;
    config_setting_t *tables;
    if (!cfg_only(r, r->root, keys) || !cfg_text(r, r->root, "machine", &machine) ||
        !cfg_text(r, r->root, "program", &program) || !cfg_list(r, r->root, "tables", &tables))
        return false;
    p->machine = xstrdup(machine);
    p->program = xstrdup(program);
    p->count = (size_t)config_setting_length(tables);
    p->tables = xcalloc(p->count, sizeof *p->tables);
    for (unsigned i = 0; i < p->count; i++)
        if (!read_table(r, config_setting_get_elem(tables, i), &p->tables[i]))
            return false;
    return paper_read_notes(r, p);
}

struct paper *paper_read(const char *path, char **error)
{
    struct cfg_reader r;
    struct paper *p = xcalloc(1, sizeof *p);
    bool ok = cfg_open(&r, path) && read_paper(&r, p);
    cfg_close(&r);
    if (ok)
        return p;
    *error = r.error;
    paper_free(p);
    return NULL;
}
