/* plan.c - reads published.cfg. The reader stays open until the program ends, since it owns the texts. */
#include "validate.h"
#include <stdlib.h>
#include <string.h>
#include "config/reader.h"

static struct cfg_reader reader;

static void *array(size_t count, size_t size)
{
    void *p = calloc(count ? count : 1, size);
    if (!p)
        abort();
    return p;
}

static size_t list(const char *key, config_setting_t **out)
{
    return cfg_list(&reader, reader.root, key, out) ? (size_t)config_setting_length(*out) : 0;
}

static const char *text_or(config_setting_t *in, const char *key, const char *otherwise)
{
    const char *text = otherwise;
    config_setting_lookup_string(in, key, &text);
    return text;
}

static double number_or(config_setting_t *in, const char *key, double otherwise)
{
    double x = otherwise;
    if (config_setting_get_member(in, key))
        cfg_number(&reader, in, key, -1e12, 1e12, &x);
    return x;
}

static const struct run *run_of(const struct plan *p, config_setting_t *in)
{
    const char *name;
    if (!cfg_text(&reader, in, "run", &name))
        return NULL;
    for (size_t i = 0; i < p->run_count; i++)
        if (strcmp(p->runs[i].name, name) == 0)
            return &p->runs[i];
    cfg_fail(&reader, in, "run", "there is no run \"%s\"", name);
    return NULL;
}

static void read_run(struct run *r, config_setting_t *in)
{
    static const char *const keys[] = {"name", "program", "machine", "costs", "nodes", "arguments", NULL};
    config_setting_t *nodes = config_setting_get_member(in, "nodes");
    if (!cfg_only(&reader, in, keys) || !cfg_text(&reader, in, "name", &r->name) ||
        !cfg_text(&reader, in, "program", &r->program) || !cfg_text(&reader, in, "machine", &r->machine))
        return;
    r->arguments = text_or(in, "arguments", "");
    r->costs = text_or(in, "costs", "i860.cfg");
    r->sizes = nodes ? (size_t)config_setting_length(nodes) : 0;
    if (r->sizes == 0 || r->sizes > MAX_SIZES)
        cfg_fail(&reader, in, "nodes", "must be a list of 1 to %d numbers: nodes = [2, 4];", MAX_SIZES);
    for (size_t i = 0; i < r->sizes && i < MAX_SIZES; i++)
        r->nodes[i] = (unsigned)config_setting_get_int_elem(nodes, (int)i);
}

static void read_figure(struct plan *p, struct figure *f, config_setting_t *in)
{
    static const char *const keys[] = {"run",    "figure", "text",     "unit",   "value",  "low", "high",
                                       "within", "source", "standing", "misses", "fitted", NULL};
    f->run = run_of(p, in);
    f->open = !config_setting_get_member(in, "value") && !config_setting_get_member(in, "low");
    f->unit = text_or(in, "unit", "");
    f->source = text_or(in, "source", "");
    f->miss = text_or(in, "misses", NULL);
    f->low = number_or(in, "low", number_or(in, "value", 0));
    f->high = number_or(in, "high", f->low);
    f->within = number_or(in, "within", 0.05);
    f->fitted = config_setting_get_member(in, "fitted");
    if (cfg_only(&reader, in, keys) && cfg_text(&reader, in, "figure", &f->name) &&
        cfg_text(&reader, in, "text", &f->text))
        cfg_text(&reader, in, "standing", &f->standing);
}

static void read_curve(struct plan *p, struct curve *c, config_setting_t *in)
{
    static const char *const keys[] = {"run",      "series", "text",   "pieces", "source",
                                       "standing", "within", "fitted", NULL};
    config_setting_t *pieces;
    c->run = run_of(p, in);
    c->within = number_or(in, "within", 0.05);
    c->fitted = config_setting_get_member(in, "fitted");
    if (!cfg_only(&reader, in, keys) || !cfg_text(&reader, in, "series", &c->series) ||
        !cfg_text(&reader, in, "text", &c->text) || !cfg_text(&reader, in, "standing", &c->standing) ||
        !cfg_text(&reader, in, "source", &c->source) || !cfg_list(&reader, in, "pieces", &pieces))
        return;
    for (int i = 0; i < config_setting_length(pieces) && i < MAX_PIECES; i++) {
        config_setting_t *piece = config_setting_get_elem(pieces, (unsigned)i);
        c->pieces[c->piece_count++] =
            (struct piece){number_or(piece, "most", 1e12), number_or(piece, "constant", 0),
                           number_or(piece, "per_x", 0), number_or(piece, "per_y", 0)};
    }
}

static void read_listing(struct plan *p, struct listing *l, config_setting_t *in)
{
    l->run = run_of(p, in);
    if (cfg_text(&reader, in, "title", &l->title) && cfg_text(&reader, in, "x", &l->x))
        cfg_text(&reader, in, "y", &l->y);
}

bool plan_read(struct plan *p, const char *path, char **error)
{
    config_setting_t *l;
    *p = (struct plan){0};
    if (cfg_open(&reader, path)) {
        p->runs = array(p->run_count = list("runs", &l), sizeof *p->runs);
        for (size_t i = 0; i < p->run_count; i++)
            read_run(&p->runs[i], config_setting_get_elem(l, (unsigned)i));
        p->figures = array(p->figure_count = list("figures", &l), sizeof *p->figures);
        for (size_t i = 0; i < p->figure_count; i++)
            read_figure(p, &p->figures[i], config_setting_get_elem(l, (unsigned)i));
        p->curves = array(p->curve_count = list("curves", &l), sizeof *p->curves);
        for (size_t i = 0; i < p->curve_count; i++)
            read_curve(p, &p->curves[i], config_setting_get_elem(l, (unsigned)i));
        p->listings = array(p->listing_count = list("listings", &l), sizeof *p->listings);
        for (size_t i = 0; i < p->listing_count; i++)
            read_listing(p, &p->listings[i], config_setting_get_elem(l, (unsigned)i));
        p->remark_count = list("remarks", &l);
        const char **remarks = array(p->remark_count, sizeof *remarks);
        for (size_t i = 0; i < p->remark_count; i++)
            remarks[i] = config_setting_get_string_elem(l, (int)i);
        p->remarks = remarks;
    }
    *error = reader.error;
    return !*error;
}
