/* study_points.c - reads the points' results from the journal, one at a time; see study.h. */
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/jobs/outcome.h"
#include "lab/study/study_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* For bsearch() in s->work, which is sorted by number. */
static int compare_number(const void *number, const void *work)
{
    uint64_t x = *(const uint64_t *)number, y = ((const struct work *)work)->number;
    return x < y ? -1 : x > y;
}

/* The record of the point of that number, owned by the caller; NULL if the point is left out or has not been
 * run. */
static json_t *record_of(const struct study *s, uint64_t number)
{
    const struct work *w = bsearch(&number, s->work, s->count, sizeof *w, compare_number);
    return w ? journal_record(s->journal, w->key) : NULL;
}

/* --- speed against the fewest nodes --------------------------------------------------------------------- */

/* The total time that the program printed, or else the run's virtual time. */
static double time_of(const json_t *figures)
{
    double total = figure_of(figures, "total_s");
    return isnan(total) ? figure_of(figures, "virtual_time_s") : total;
}

/* The difference in number between points of successive values on the axis. */
static size_t stride(const struct spec *s, size_t axis)
{
    size_t points = 1;
    for (size_t i = axis + 1; i < s->axis_count; i++)
        points *= s->axes[i].count;
    return points;
}

/* nodes x time of the point of fewest nodes among those otherwise equal to p; NAN if none has a time. */
static double base_work(const struct study *s, const struct point *p, size_t axis)
{
    const struct spec_axis *nodes = &s->spec->axes[axis];
    size_t apart = stride(s->spec, axis), first = p->number - p->number / apart % nodes->count * apart;
    double fewest = INFINITY, work = NAN;
    char label[SPEC_MAX_LABEL];
    const char *text;
    for (size_t i = 0; i < nodes->count; i++) {
        double n = spec_value(nodes, i, &text, label);
        if (!(n < fewest))
            continue;
        json_t *record = record_of(s, first + i * apart);
        double time = time_of(json_object_get(record, "figures"));
        if (!isnan(time)) {
            fewest = n;
            work = n * time;
        }
        json_decref(record);
    }
    return work;
}

static void add_speed(const struct study *s, const struct point *p, json_t *flat)
{
    double own = time_of(flat);
    if (!isnan(own) && !json_object_get(flat, "time_s"))
        json_set(flat, "time_s", json_real(own));
    const struct spec_axis *nodes = spec_axis(s->spec, "nodes");
    if (!nodes || nodes->kind == SPEC_DERIVED)
        return;
    size_t axis = spec_axis_index(s->spec, nodes);
    double time = own, work = time > 0 ? base_work(s, p, axis) : NAN;
    if (isnan(work))
        return;
    if (!json_object_get(flat, "speedup"))
        json_set(flat, "speedup", json_real(work / time));
    if (!json_object_get(flat, "speed_per_node"))
        json_set(flat, "speed_per_node", json_real(work / time / p->value[axis].number));
}

/* --- all ------------------------------------------------------------------------------------------------ */

/* The point as study_each() shows it. An axis hides a figure of the same name. */
static json_t *flat_point(const struct study *s, const struct point *p, const json_t *record)
{
    json_t *flat = point_values(s->spec, p), *failure = json_object_get(record, "failure"),
           *figures = json_object_get(record, "figures"), *profile = json_object_get(record, "profile");
    json_set(flat, "failure", failure ? json_incref(failure) : json_null());
    json_set(flat, "wall_time_s", json_incref(json_object_get(record, "wall_time_s")));
    if (figures && json_object_update_missing(flat, figures) != 0)
        xexhausted();
    add_speed(s, p, flat);
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

bool study_each(struct study *s, study_visit *visit, void *arg, char **error)
{
    study_sort(s, false);
    for (size_t i = 0; i < s->count; i++)
        if (!visit_one(s, &s->work[i], visit, arg, error))
            return false;
    return true;
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

json_t *study_header(const struct study *s)
{
    json_t *axes = json_object();
    for (size_t i = 0; i < s->spec->axis_count; i++)
        if (s->spec->axes[i].kind != SPEC_DERIVED)
            json_set(axes, s->spec->axes[i].name, axis_values(&s->spec->axes[i]));
    return json_pack("{s:s, s:s, s:s, s:o}", "title", s->spec->title, "about", s->spec->about, "program",
                     s->spec->program, "axes", axes);
}
