/* speedup.c - see speedup.h. */
#include "lab/chart/speedup.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/chart/chart_data.h"
#include "lab/chart/record.h"
#include "lab/jobs/outcome.h"
#include "files/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct speedup {
    json_t *axes;  /* { NAME: [value ...] }: those of the study */
    json_t *only;  /* { AXIS: "VALUE" }: what a baseline must be */
    json_t *each;  /* { AXIS: null }: each value has a baseline */
    json_t *bases; /* { values on the axes of `each`: the point that is their baseline } */
};

/* --- what is said of the baseline ----------------------------------------------------------------------- */

static bool has_value(const json_t *values, const char *text)
{
    size_t i;
    json_t *value;
    bool found = false;
    json_array_foreach(values, i, value)
    {
        char *label = chart_label(value);
        found |= strcmp(label, text) == 0;
        free(label);
    }
    return found;
}

/* Takes a text of the list: "AXIS=VALUE", or the name of an axis. */
static bool take_text(struct speedup *s, const char *text, char **error)
{
    const char *sign = strchr(text, '=');
    char *name = sign ? xasprintf("%.*s", (int)(sign - text), text) : xstrdup(text);
    json_t *values = json_object_get(s->axes, name);
    bool ok = values && (!sign || has_value(values, sign + 1));
    if (!values) {
        char *none = record_no_axis(s->axes, name);
        *error = xasprintf("baseline \"%s\": %s", text, none);
        free(none);
    } else if (!ok)
        *error = xasprintf("baseline \"%s\": axis %s has no value %s", text, name, sign + 1);
    else
        json_set(sign ? s->only : s->each, name, sign ? json_string(sign + 1) : json_null());
    free(name);
    return ok;
}

/* --- the baselines -------------------------------------------------------------------------------------- */

static bool may_be_base(const struct speedup *s, const json_t *point)
{
    const char *name;
    json_t *wanted;
    bool may = figure_of(point, "nodes") > 0 && figure_of(point, "time_s") > 0;
    json_object_foreach(s->only, name, wanted)
    {
        char *label = chart_label(json_object_get(point, name));
        may &= strcmp(label, json_string_value(wanted)) == 0;
        free(label);
    }
    return may;
}

/* The name under which s->bases has the point's baseline, malloc'd. */
static char *key_of(const struct speedup *s, const json_t *point)
{
    const char *name;
    json_t *nothing;
    char *key = xstrdup("");
    json_object_foreach(s->each, name, nothing)
    {
        char *label = chart_label(json_object_get(point, name));
        words_append(&key, "%s\n", label);
        free(label);
    }
    return key;
}

static bool is_better(const json_t *point, const json_t *base)
{
    double nodes = figure_of(point, "nodes"), fewest = figure_of(base, "nodes");
    return nodes < fewest || (nodes == fewest && figure_of(point, "time_s") < figure_of(base, "time_s"));
}

/* Of the point, a baseline is kept with its axes, nodes and time only. */
static json_t *base_of(const struct speedup *s, const json_t *point)
{
    json_t *base = json_object(), *values;
    const char *name;
    json_object_foreach(s->axes, name, values)
        json_set(base, name, json_incref(json_object_get(point, name)));
    json_set(base, "nodes", json_incref(json_object_get(point, "nodes")));
    json_set(base, "time_s", json_incref(json_object_get(point, "time_s")));
    return base;
}

static bool compare_point(void *arg, const json_t *point, char **error)
{
    struct speedup *s = arg;
    (void)error;
    if (!may_be_base(s, point))
        return true;
    char *key = key_of(s, point);
    json_t *base = json_object_get(s->bases, key);
    if (!base || is_better(point, base))
        json_set(s->bases, key, base_of(s, point));
    free(key);
    return true;
}

struct speedup *speedup_find(const struct record_points *points, const char *const *said, char **error)
{
    struct speedup *s = xcalloc(1, sizeof *s);
    *s = (struct speedup){json_incref(json_object_get(points->header, "axes")), json_object(), json_object(),
                          json_object()};
    bool ok = true;
    for (; ok && said && *said; said++)
        ok = take_text(s, *said, error);
    if (ok && points->each(points->arg, compare_point, s, error))
        return s;
    speedup_free(s);
    return NULL;
}

void speedup_free(struct speedup *s)
{
    if (!s)
        return;
    json_decref(s->axes);
    json_decref(s->only);
    json_decref(s->each);
    json_decref(s->bases);
    free(s);
}

/* --- the figures ---------------------------------------------------------------------------------------- */

static void set_figure(json_t *point, const char *key, double value, bool anew)
{
    if (anew || !json_object_get(point, key))
        json_set(point, key, json_real(value));
}

void speedup_add(const struct speedup *s, json_t *point, bool anew)
{
    char *key = key_of(s, point);
    const json_t *base = json_object_get(s->bases, key);
    double nodes = figure_of(point, "nodes"), time = figure_of(point, "time_s");
    free(key);
    if (!base || !(nodes > 0) || !(time > 0))
        return;
    double speedup = figure_of(base, "nodes") * figure_of(base, "time_s") / time;
    set_figure(point, "speedup", speedup, anew);
    set_figure(point, "speed_per_node", speedup / nodes, anew);
}

/* "nodes 4, group 8": the point on the axes of several values. */
static char *name_of(const struct speedup *s, const json_t *point)
{
    char *text = xstrdup("");
    const char *name;
    json_t *values;
    json_object_foreach(s->axes, name, values)
    {
        if (json_array_size(values) < 2)
            continue;
        char *label = chart_label(json_object_get(point, name));
        words_append(&text, "%s%s %s", *text ? ", " : "", name, label);
        free(label);
    }
    return text;
}

/* Has a baseline several nodes? Then its speed-up, which is its nodes, is an assumption. */
static bool is_assumed(const struct speedup *s)
{
    const char *key;
    json_t *base;
    json_object_foreach(s->bases, key, base) if (figure_of(base, "nodes") > 1) return true;
    return false;
}

/* "the fewest nodes of each image and machine, group 8": several baselines. */
static char *names_of(const struct speedup *s)
{
    const char *name, *before = "the fewest nodes of each ";
    json_t *value;
    char *text = xstrdup("");
    json_object_foreach(s->each, name, value)
    {
        words_append(&text, "%s%s", before, name);
        before = " and ";
    }
    json_object_foreach(s->only, name, value) words_append(&text, ", %s %s", name, json_string_value(value));
    return text;
}

char *speedup_baseline(const struct speedup *s)
{
    if (json_object_size(s->bases) == 0)
        return xstrdup("");
    char *text = json_object_size(s->each) == 0
                     ? name_of(s, json_object_iter_value(json_object_iter(s->bases)))
                     : names_of(s);
    if (*text && is_assumed(s)) /* a study of one point has no other to compare with */
        words_append(&text, ", assumed ideal");
    return text;
}

bool speedup_renew(struct record_points *points, const char *const *said, char **error)
{
    struct speedup *s = speedup_find(points, said, error);
    size_t i;
    json_t *point;
    if (!s)
        return false;
    json_array_foreach(json_object_get(points->header, "points"), i, point) speedup_add(s, point, true);
    char *baseline = speedup_baseline(s);
    json_set(points->header, "baseline", json_string(baseline));
    free(baseline);
    speedup_free(s);
    return true;
}
