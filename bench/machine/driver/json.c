/* json.c - the results as JSON. */
#include "validate.h"
#include <jansson.h>

static json_t *figure_json(const struct figure *f)
{
    json_t *o = json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s}", "run", f->run->name, "figure", f->name,
                          "text", f->text, "unit", f->unit, "standing", f->standing, "source", f->source,
                          "verdict", verdict_name(f->verdict));
    json_object_set_new(o, "simulated", json_real(f->simulated));
    json_object_set_new(o, "fitted", json_boolean(f->fitted));
    if (!f->open) {
        json_object_set_new(o, "low", json_real(f->low));
        json_object_set_new(o, "high", json_real(f->high));
        json_object_set_new(o, "error", json_real(f->error));
    }
    return o;
}

static json_t *curve_json(const struct curve *c)
{
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:i, s:f}", "run", c->run->name, "series", c->series,
                     "text", c->text, "standing", c->standing, "source", c->source, "verdict",
                     verdict_name(c->verdict), "points", (int)c->points, "worst_error", c->worst);
}

static json_t *run_json(const struct run *r)
{
    json_t *points = json_array();
    for (size_t i = 0; i < r->point_count; i++)
        json_array_append_new(points, json_pack("[s, f, f, f]", r->points[i].series, r->points[i].x[0],
                                                r->points[i].x[1], r->points[i].y));
    return json_pack("{s:s, s:s, s:s, s:s, s:o}", "name", r->name, "program", r->program, "machine",
                     r->machine, "arguments", r->arguments, "points", points);
}

bool report_json(const struct plan *p, const char *path)
{
    json_t *figures = json_array(), *curves = json_array(), *runs = json_array();
    for (size_t i = 0; i < p->figure_count; i++)
        json_array_append_new(figures, figure_json(&p->figures[i]));
    for (size_t i = 0; i < p->curve_count; i++)
        json_array_append_new(curves, curve_json(&p->curves[i]));
    for (size_t i = 0; i < p->run_count; i++)
        json_array_append_new(runs, run_json(&p->runs[i]));
    json_t *root = json_pack("{s:o, s:o, s:o}", "figures", figures, "formulas", curves, "runs", runs);
    bool written = json_dump_file(root, path, JSON_INDENT(1) | JSON_REAL_PRECISION(9)) == 0;
    json_decref(root);
    return written;
}
