/* points.c - turns a point's number into values, and values into settings and arguments; see points.h. */
#include "lab/study/points.h"
#include "files/json_set.h"
#include "files/number.h"
#include "kernel/xalloc.h"
#include "files/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- a point's values ----------------------------------------------------------------------------------- */

/* The index of the axis's value in the point's number, and in *rest the number without this axis: axes are
 * mixed-radix digits. */
static size_t digit(const struct spec_axis *axis, size_t *rest)
{
    size_t at = *rest % axis->count;
    *rest /= axis->count;
    return at;
}

/* The settings and arguments of the point's value on the axis; empty ones if the axis's condition `when` does
 * not hold. */
static const struct spec_value *said_at(const struct spec *s, const struct point *p, size_t axis)
{
    static const struct spec_value nothing = {.arguments = ""};
    const struct spec_axis *a = &s->axes[axis];
    size_t rest = p->number, at = 0;
    for (size_t i = s->axis_count; i-- > axis;)
        at = digit(&s->axes[i], &rest);
    if (a->when && !(expr_number(a->when, p->value) != 0))
        return &nothing;
    return &a->values[a->kind == SPEC_LIST ? at : 0];
}

static bool derive(const struct spec *s, struct point *p, size_t axis, char **error)
{
    const struct spec_axis *a = &s->axes[axis];
    double number = expr_number(a->value, p->value);
    bool nodes = strcmp(a->name, "nodes") == 0;
    if (!isfinite(number) || (nodes && (number < 1 || number > SPEC_MAX_NODES || number != floor(number)))) {
        char *name = point_name(s, p);
        *error = xasprintf("%s:%d: %s: \"%s\" is %g at %s: %s is needed", s->path,
                           config_setting_source_line(a->at), a->name, expr_text(a->value), number, name,
                           nodes ? "a whole number of nodes" : "a number");
        free(name);
        return false;
    }
    spec_label(number, p->label[axis]);
    p->value[axis] = (struct expr_value){strtod(p->label[axis], NULL), p->label[axis]};
    return true;
}

/* Derives what follows from the other values, and asks whether the point is wanted. Sets *broken to a
 * condition of `only` that does not hold. */
static enum point_is finish(const struct spec *s, struct point *p, const char **broken, char **error)
{
    for (size_t i = 0; i < s->axis_count; i++)
        if (s->axes[i].kind == SPEC_DERIVED && !derive(s, p, i, error))
            return POINT_WRONG;
    for (size_t i = 0; i < s->only_count; i++) {
        double holds = expr_number(s->only[i], p->value);
        if (holds == 0 || isnan(holds)) {
            *broken = expr_text(s->only[i]);
            return POINT_LEFT_OUT;
        }
    }
    return POINT_WANTED;
}

enum point_is point_make(const struct spec *s, size_t number, struct point *p, char **error)
{
    size_t rest = number;
    const char *broken;
    p->number = number;
    for (size_t i = s->axis_count; i-- > 0;) {
        const struct spec_axis *axis = &s->axes[i];
        size_t at = digit(axis, &rest);
        p->value[i] = (struct expr_value){NAN, "?"};
        if (axis->kind != SPEC_DERIVED)
            p->value[i].number = spec_value(axis, at, &p->value[i].text, p->label[i]);
    }
    return finish(s, p, &broken, error);
}

/* --- a point that is not of the study ------------------------------------------------------------------- */

bool point_axis_is_open(const struct spec_axis *axis)
{
    return axis->numeric && axis->kind != SPEC_DERIVED && !config_setting_get_member(axis->at, "cases");
}

/* The number that a text or number of JSON is; NAN if none. */
static double number_of(const json_t *value)
{
    double number = json_is_number(value) ? json_number_value(value) : NAN, unit;
    if (json_is_string(value) && !number_read(json_string_value(value), &number, &unit))
        return NAN;
    return number;
}

/* Finds the value among the axis's own; axis->count if there is none. */
static size_t own_value(const struct spec_axis *axis, double number, const char *text)
{
    char label[SPEC_MAX_LABEL];
    const char *own;
    size_t i = 0;
    for (; i < axis->count; i++) {
        double value = spec_value(axis, i, &own, label);
        if ((text && strcmp(own, text) == 0) || value == number)
            break;
    }
    return i;
}

/* Sets the point's value on an axis to one that the study file does not name. */
static bool choose_new(const struct spec *s, const struct spec_axis *axis, double number, struct point *p,
                       char **error)
{
    size_t i = spec_axis_index(s, axis);
    bool nodes = strcmp(axis->name, "nodes") == 0;
    if (!point_axis_is_open(axis) || !isfinite(number))
        return *error = xasprintf("%s: %s", axis->name,
                                  point_axis_is_open(axis) ? "a number is needed"
                                                           : "this is none of the study's values"),
               false;
    if (nodes && (number < 1 || number > SPEC_MAX_NODES || number != floor(number)))
        return *error = xasprintf("nodes: a whole number from 1 to %d is needed", SPEC_MAX_NODES), false;
    spec_label(number, p->label[i]);
    p->value[i] = (struct expr_value){strtod(p->label[i], NULL), p->label[i]};
    return true;
}

static bool choose_on(const struct spec *s, const struct spec_axis *axis, const json_t *value,
                      struct point *p, char **error)
{
    size_t i = spec_axis_index(s, axis);
    double number = number_of(value);
    if (!json_is_string(value) && !json_is_number(value))
        return *error = xasprintf("%s: a value is needed", axis->name), false;
    size_t own = own_value(axis, number, json_string_value(value));
    if (own == axis->count)
        return choose_new(s, axis, number, p, error);
    p->value[i].number = spec_value(axis, own, &p->value[i].text, p->label[i]);
    p->number += own;
    return true;
}

enum point_is point_choose(const struct spec *s, const json_t *values, struct point *p, char **error)
{
    const char *broken, *name;
    json_t *value;
    json_object_foreach((json_t *)values, name, value)
    {
        const struct spec_axis *axis = spec_axis(s, name);
        if (!axis || axis->kind == SPEC_DERIVED)
            return *error = xasprintf("%s: there is no such axis whose value can be chosen", name),
                   POINT_WRONG;
    }
    p->number = 0;
    for (size_t i = 0; i < s->axis_count; i++) {
        const struct spec_axis *axis = &s->axes[i];
        p->number *= axis->count;
        p->value[i] = (struct expr_value){NAN, "?"};
        if (axis->kind != SPEC_DERIVED && !choose_on(s, axis, json_object_get(values, axis->name), p, error))
            return POINT_WRONG;
    }
    enum point_is is = finish(s, p, &broken, error);
    if (is == POINT_LEFT_OUT)
        *error = xasprintf("the study leaves out points for which this does not hold: %s", broken);
    return is;
}

/* --- what it is called, and what its run is given ------------------------------------------------------- */

char *point_name(const struct spec *s, const struct point *p)
{
    char *name = xstrdup("");
    for (size_t i = 0; i < s->axis_count; i++)
        words_append(&name, "%s%s %s", i ? ", " : "", s->axes[i].name, p->value[i].text);
    return name;
}

uint64_t point_nodes(const struct spec *s, const struct point *p)
{
    const struct spec_axis *axis = spec_axis(s, "nodes");
    return axis ? (uint64_t)p->value[spec_axis_index(s, axis)].number : s->nodes;
}

const char *point_machine(const struct spec *s, const struct point *p)
{
    const struct spec_axis *axis = spec_axis(s, "machine");
    return axis ? p->value[spec_axis_index(s, axis)].text : s->machine;
}

char **point_arguments(const struct spec *s, const struct point *p)
{
    char **list = NULL;
    words_add_all(&list, xstrdup(s->arguments));
    for (size_t i = 0; i < s->axis_count; i++) {
        const char *own = said_at(s, p, i)->arguments;
        if (own)
            words_add_all(&list, words_filled(own, "{}", p->value[i].text));
    }
    return list;
}

char **point_settings(const struct spec *s, const struct point *p)
{
    char **list = NULL;
    for (size_t i = 0; i < s->axis_count; i++) {
        config_setting_t *set = said_at(s, p, i)->set;
        for (int k = 0; set && k < config_setting_length(set); k++)
            words_add(&list, words_filled(config_setting_get_string_elem(set, k), "{}", p->value[i].text));
    }
    return list;
}

config_setting_t *point_setting_at(const struct spec *s, const struct point *p, size_t n)
{
    for (size_t i = 0; i < s->axis_count; i++) {
        config_setting_t *set = said_at(s, p, i)->set;
        size_t count = set ? (size_t)config_setting_length(set) : 0;
        if (n < count)
            return config_setting_get_elem(set, (unsigned)n);
        n -= count;
    }
    return NULL;
}

json_t *point_value_json(double number, const char *text)
{
    if (isnan(number))
        return json_string(text);
    if (number == floor(number) && fabs(number) < 1e15)
        return json_integer((json_int_t)number);
    return json_real(number);
}

json_t *point_values(const struct spec *s, const struct point *p)
{
    json_t *values = json_object();
    for (size_t i = 0; i < s->axis_count; i++)
        json_set(values, s->axes[i].name, point_value_json(p->value[i].number, p->value[i].text));
    return values;
}
