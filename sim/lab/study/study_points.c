/* study_points.c - reads the points' results from the journal, one at a time; see study.h, study_points.h. */
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/study/point_run.h"
#include "lab/study/study_points.h"

#include <stdlib.h>
#include <string.h>

/* --- a point -------------------------------------------------------------------------------------------- */

/* The point as study_each() shows it, without its speeds. An axis hides a figure of the same name. */
static json_t *flat_point(const struct study *s, const struct point *p, const json_t *record)
{
    json_t *flat = point_flat(point_values(s->spec, p), record),
           *profile = json_object_get(record, "profile");
    if (profile)
        json_set(flat, "profile", json_incref(profile));
    return flat;
}

static bool visit_one(struct study *s, const struct work *w, study_visit *visit, void *arg, char **error)
{
    struct point p;
    json_t *record =
        point_make(s->spec, w->number, &p, error) == POINT_WANTED ? journal_record(s->journal, w->key) : NULL;
    if (!record) {
        char *name = point_name(s->spec, &p);
        *error = xasprintf("%s: no result of %s; run the study again", s->options.dir, name);
        free(name);
        return false;
    }
    json_t *flat = flat_point(s, &p, record);
    bool on = visit(arg, flat, error);
    json_decref(flat);
    json_decref(record);
    return on;
}

/* --- all points ----------------------------------------------------------------------------------------- */

static bool each_without_speeds(void *study, study_visit *visit, void *arg, char **error)
{
    struct study *s = study;
    study_sort(s, false);
    for (size_t i = 0; i < s->count; i++)
        if (!visit_one(s, &s->work[i], visit, arg, error))
            return false;
    return true;
}

bool study_find_baseline(struct study *s, char **error)
{
    if (s->speedup || !spec_axis(s->spec, "nodes"))
        return true;
    struct record_points points = {each_without_speeds, s, study_header(s)};
    s->speedup = speedup_find(&points, s->spec->baseline, error);
    json_decref(points.header);
    return s->speedup;
}

struct with_speeds {
    const struct speedup *speedup;
    study_visit *visit;
    void *arg;
};

static bool add_speeds(void *arg, const json_t *point, char **error)
{
    const struct with_speeds *w = arg;
    json_t *all = json_copy((json_t *)point);
    speedup_add(w->speedup, all, false);
    bool on = w->visit(w->arg, all, error);
    json_decref(all);
    return on;
}

bool study_each(struct study *s, study_visit *visit, void *arg, char **error)
{
    if (!study_find_baseline(s, error))
        return false;
    struct with_speeds with = {s->speedup, visit, arg};
    return s->speedup ? each_without_speeds(s, add_speeds, &with, error)
                      : each_without_speeds(s, visit, arg, error);
}

static json_t *axis_values(const struct spec_axis *axis)
{
    json_t *values = json_array();
    char label[SPEC_MAX_LABEL];
    for (size_t i = 0; i < axis->count; i++) {
        const char *text;
        double number = spec_value(axis, i, &text, label);
        json_array_append_new(values, point_value_json(number, text));
    }
    return values;
}

/* The study's title, malloc'd. One without is called by its program and machine: "jacobi on delta". */
static char *title_of(const struct spec *s)
{
    const char *program = basename(s->program);
    return *s->title     ? xstrdup(s->title)
           : *s->machine ? xasprintf("%s on %s", program, s->machine)
                         : xstrdup(program);
}

json_t *study_header(const struct study *s)
{
    char *title = title_of(s->spec);
    json_t *axes = json_object();
    for (size_t i = 0; i < s->spec->axis_count; i++)
        if (s->spec->axes[i].kind != SPEC_DERIVED)
            json_set(axes, s->spec->axes[i].name, axis_values(&s->spec->axes[i]));
    json_t *header = json_pack("{s:s, s:s, s:s, s:o}", "title", title, "about", s->spec->about, "program",
                               s->spec->program, "axes", axes);
    free(title);
    return header;
}
