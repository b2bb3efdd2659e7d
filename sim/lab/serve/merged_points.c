/* merged_points.c - see merged_points.h. */
#include "lab/serve/merged_points.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>
#include "files/json_set.h"
#include "lab/jobs/outcome.h"

static bool equal(const json_t *a, const json_t *b)
{
    return json_is_number(a) && json_is_number(b) ? json_number_value(a) == json_number_value(b)
                                                  : json_equal(a, b);
}

static bool has(const json_t *list, const json_t *value)
{
    size_t i;
    json_t *one;
    json_array_foreach(list, i, one) if (equal(one, value)) return true;
    return false;
}

/* --- axes ----------------------------------------------------------------------------------------------- */

/* Adds the value to the list, before the first number that is more. */
static void add_value(json_t *list, json_t *value)
{
    size_t at = 0, count = json_array_size(list);
    if (!value || has(list, value))
        return;
    while (at < count && json_is_number(value) &&
           json_number_value(json_array_get(list, at)) < json_number_value(value))
        at++;
    json_array_insert(list, json_is_number(value) ? at : count, value);
}

static void add_to_axes(json_t *axes, const json_t *point)
{
    const char *name;
    json_t *values;
    json_object_foreach(axes, name, values) add_value(values, json_object_get(point, name));
}

/* Is the point on all axes? */
static bool is_on(const json_t *axes, const json_t *point)
{
    const char *name;
    json_t *values;
    json_object_foreach((json_t *)axes, name,
                        values) if (!has(values, json_object_get(point, name))) return false;
    return true;
}

/* Settings are an axis of their own, whose first value is the study's own machine. */
static void add_settings_axis(json_t *axes, const json_t *points)
{
    json_t *values = json_pack("[s]", ""), *point;
    size_t i;
    json_array_foreach(points, i, point)
    {
        json_t *set = json_object_get(point, "set");
        if (!set)
            json_set(point, "set", json_string(""));
        else if (!has(values, set))
            json_array_append(values, set);
    }
    json_set(axes, "set", values);
}

/* --- speed ---------------------------------------------------------------------------------------------- */

/* Do both differ at most in their numbers of nodes? */
static bool is_comparable(const json_t *axes, const json_t *a, const json_t *b)
{
    const char *name;
    json_t *values;
    json_object_foreach((json_t *)axes, name, values)
    {
        if (strcmp(name, "nodes") && !equal(json_object_get(a, name), json_object_get(b, name)))
            return false;
    }
    return true;
}

/* As of the study's points: the same work in the time of this one. */
static void add_speed(const json_t *axes, const json_t *own, json_t *point)
{
    double time = figure_of(point, "time_s"), nodes = figure_of(point, "nodes");
    size_t i;
    json_t *other;
    json_array_foreach(own, i, other)
    {
        double work = figure_of(other, "speedup") * figure_of(other, "time_s");
        if (!(work > 0 && time > 0) || !is_comparable(axes, point, other))
            continue;
        json_set(point, "speedup", json_real(work / time));
        if (nodes > 0)
            json_set(point, "speed_per_node", json_real(work / time / nodes));
        return;
    }
}

/* --- all ------------------------------------------------------------------------------------------------ */

static json_t *own_points(const json_t *axes, const json_t *own)
{
    json_t *list = json_array(), *point;
    const char *key;
    size_t i;
    json_array_foreach(own, i, point) json_append(list, json_copy(point));
    json_object_foreach((json_t *)own, key, point) if (is_on(axes, point))
        json_append(list, json_copy(point));
    return list;
}

json_t *merged_points(const json_t *header, const json_t *own, const json_t *added)
{
    static const char *const TEXTS[] = {"title", "about", "program"};
    json_t *data = json_object(), *axes = json_object_get(header, "axes"), *point;
    bool settings = false;
    const char *key;
    for (size_t i = 0; i < sizeof TEXTS / sizeof *TEXTS; i++) {
        const char *text = json_string_value(json_object_get(header, TEXTS[i]));
        json_set(data, TEXTS[i], json_string(text ? text : ""));
    }
    if (json_object_get(header, "baseline"))
        json_set(data, "baseline", json_copy(json_object_get(header, "baseline")));
    axes = axes ? json_deep_copy(axes) : json_object();
    json_t *points = own_points(axes, own), *compared = json_copy(points);
    json_object_foreach((json_t *)added, key, point)
    {
        json_t *copy = json_copy(point);
        const char *set = json_string_value(json_object_get(copy, "set"));
        add_speed(axes, compared, copy);
        json_set(copy, "added", json_true());
        settings |= set && *set;
        add_to_axes(axes, copy);
        json_append(points, copy);
    }
    json_decref(compared);
    if (settings && !json_object_get(axes, "set"))
        add_settings_axis(axes, points);
    json_set(data, "axes", axes);
    json_set(data, "points", points);
    return data;
}
