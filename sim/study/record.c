/* record.c - see record.h. */
#include "study/record.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void set(json_t *object, const char *key, json_t *value)
{
    if (json_object_set_new(object, key, value) != 0)
        abort();
}

static json_t *value_json(const struct spec_value *value)
{
    if (isnan(value->number))
        return json_string(value->label);
    if (value->number == floor(value->number) && fabs(value->number) < 1e15)
        return json_integer((json_int_t)value->number);
    return json_real(value->number);
}

/* Axes come first, and hide figures of the same name. */
static json_t *point_json(const struct spec *s, const struct point *p)
{
    json_t *j = json_object();
    for (size_t i = 0; i < s->axis_count; i++)
        set(j, s->axes[i].name, value_json(&s->axes[i].values[p->at[i]]));
    set(j, "failure", p->failure ? json_string(p->failure) : json_null());
    set(j, "wall_time_s", json_real(p->wall_time_s));
    if (json_object_update_missing(j, p->figures) != 0 && p->figures)
        abort();
    return j;
}

json_t *record_json(const struct points *p)
{
    const struct spec *s = p->spec;
    json_t *root = json_object(), *axes = json_object(), *points = json_array();
    for (size_t i = 0; i < s->axis_count; i++) {
        json_t *values = json_array();
        for (size_t k = 0; k < s->axes[i].count; k++)
            json_array_append_new(values, value_json(&s->axes[i].values[k]));
        set(axes, s->axes[i].name, values);
    }
    for (size_t i = 0; i < p->count; i++)
        json_array_append_new(points, point_json(s, &p->point[i]));
    set(root, "title", json_string(s->title));
    set(root, "program", json_string(s->program));
    set(root, "axes", axes);
    set(root, "points", points);
    return root;
}

/* --- comma-separated values ------------------------------------------------------------------------------ */

/* Texts in double quotes, with quotes in them doubled. */
static void write_text(const char *text, FILE *out)
{
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

static void write_cell(json_t *value, FILE *out)
{
    if (json_is_string(value))
        write_text(json_string_value(value), out);
    else if (json_is_integer(value))
        fprintf(out, "%lld", json_integer_value(value));
    else if (json_is_real(value))
        fprintf(out, "%.15g", json_real_value(value));
}

/* The names of all points' figures, in the order in which they come up. */
static json_t *columns_of(json_t *points)
{
    json_t *columns = json_object(), *point, *value;
    const char *key;
    size_t i;
    json_array_foreach(points, i, point) json_object_foreach(point, key, value) if (!json_is_array(value))
        set(columns, key, json_null());
    return columns;
}

void record_csv(const struct points *p, FILE *out)
{
    json_t *root = record_json(p), *points = json_object_get(root, "points"), *columns = columns_of(points);
    json_t *point, *value;
    const char *key, *comma = "";
    size_t i;
    json_object_foreach(columns, key, value)
    {
        fprintf(out, "%s%s", comma, key);
        comma = ",";
    }
    fputc('\n', out);
    json_array_foreach(points, i, point)
    {
        comma = "";
        json_object_foreach(columns, key, value)
        {
            fputs(comma, out);
            write_cell(json_object_get(point, key), out);
            comma = ",";
        }
        fputc('\n', out);
    }
    json_decref(columns);
    json_decref(root);
}
