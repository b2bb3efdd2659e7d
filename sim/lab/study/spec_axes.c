/* spec_axes.c - see spec_axes.h. */
#include "lab/study/spec_axes.h"
#include "kernel/xalloc.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- values --------------------------------------------------------------------------------------------- */

/* Reads a list of texts KEY=VALUE; *out stays NULL if there is none. */
static bool read_set(struct cfg_reader *r, config_setting_t *in, config_setting_t **out)
{
    *out = NULL;
    if (!config_setting_get_member(in, "set"))
        return true;
    if (!cfg_list(r, in, "set", out))
        return false;
    for (unsigned i = 0; i < (unsigned)config_setting_length(*out); i++) {
        const char *text = config_setting_get_string_elem(*out, (int)i);
        const char *sign = text ? strchr(text, '=') : NULL;
        if (!sign || sign == text)
            return cfg_fail(r, *out, "set", "must hold texts KEY=VALUE, such as \"cfs.io_nodes={}\"");
    }
    return true;
}

/* Reads a number or a text of a list of values. */
static bool read_plain(struct cfg_reader *r, config_setting_t *s, struct spec_value *value)
{
    switch (config_setting_type(s)) {
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64:
        value->number = (double)config_setting_get_int64(s);
        value->label = xasprintf("%lld", config_setting_get_int64(s));
        return true;
    case CONFIG_TYPE_FLOAT:
        value->label = xasprintf("%.15g", config_setting_get_float(s));
        value->number = strtod(value->label, NULL); /* the number that a run is given */
        return true;
    case CONFIG_TYPE_STRING:
        value->number = NAN;
        value->label = xstrdup(config_setting_get_string(s));
        return *value->label || cfg_fail(r, s, "values", "an empty text is no value");
    default:
        return cfg_fail(r, s, "values", "must hold numbers or texts; for more, give cases = ( { ... } );");
    }
}

static bool read_case(struct cfg_reader *r, config_setting_t *g, struct spec_value *value)
{
    static const char *const keys[] = {"label", "set", "arguments", NULL};
    const char *label;
    if (!config_setting_is_group(g))
        return cfg_fail(r, g, "cases", "must hold groups: { label = \"...\"; ... }");
    if (!cfg_only(r, g, keys) || !cfg_text(r, g, "label", &label) || !read_set(r, g, &value->set) ||
        !spec_optional(r, g, "arguments", &value->arguments))
        return false;
    value->label = xstrdup(label);
    value->number = NAN;
    return true;
}

/* --- the three kinds ------------------------------------------------------------------------------------ */

static bool check_nodes(struct cfg_reader *r, config_setting_t *at, const struct spec_axis *axis, size_t i)
{
    char label[SPEC_MAX_LABEL];
    const char *text;
    double number = spec_value(axis, i, &text, label);
    if (number >= 1 && number <= SPEC_MAX_NODES && floor(number) == number)
        return true;
    return cfg_fail(r, at, "nodes", "%s is not a number of nodes: whole, from 1 to %d", text, SPEC_MAX_NODES);
}

static bool check_list(struct cfg_reader *r, config_setting_t *list, const struct spec_axis *axis)
{
    if (!axis->count)
        return cfg_fail(r, list, axis->name, "is empty: at least one value is needed");
    for (size_t i = 0; i < axis->count; i++)
        for (size_t k = 0; k < i; k++)
            if (strcmp(axis->values[k].label, axis->values[i].label) == 0)
                return cfg_fail(r, list, axis->name, "%s is there twice", axis->values[i].label);
    return true;
}

static bool read_list(struct cfg_reader *r, config_setting_t *list, bool cases, struct spec_axis *axis)
{
    axis->kind = SPEC_LIST;
    axis->count = (size_t)config_setting_length(list);
    axis->values = xcalloc(axis->count, sizeof *axis->values);
    axis->numeric = true;
    for (unsigned i = 0; i < axis->count; i++) {
        config_setting_t *s = config_setting_get_elem(list, i);
        if (!(cases ? read_case : read_plain)(r, s, &axis->values[i]))
            return false;
        axis->numeric &= !isnan(axis->values[i].number);
    }
    return check_list(r, list, axis);
}

/* Reads { from = 1; to = 64; times = 2; } or { from = 0; to = 1; step = 0.1; }. */
static bool read_range(struct cfg_reader *r, config_setting_t *g, struct spec_axis *axis)
{
    static const char *const keys[] = {"from", "to", "step", "times", NULL};
    double to;
    axis->kind = SPEC_RANGE;
    axis->numeric = true;
    axis->values = xcalloc(1, sizeof *axis->values);
    axis->times = config_setting_get_member(g, "times");
    if (axis->times == !!config_setting_get_member(g, "step"))
        return cfg_fail(r, g, axis->name, "a range needs either step = ...; or times = ...;");
    if (!cfg_only(r, g, keys) ||
        !cfg_number(r, g, "from", axis->times ? 1e-300 : -1e300, 1e300, &axis->from) ||
        !cfg_number(r, g, "to", axis->from, 1e300, &to) ||
        !cfg_number(r, g, axis->times ? "times" : "step", axis->times ? 1 + 1e-9 : 1e-300, 1e300,
                    &axis->step))
        return false;
    double steps = axis->times ? log(to / axis->from) / log(axis->step) : (to - axis->from) / axis->step;
    if (!(steps < SPEC_MAX_POINTS))
        return cfg_fail(r, g, axis->name, "%.0f values: at most %d are allowed", steps + 1, SPEC_MAX_POINTS);
    axis->count = (size_t)floor(steps + 1e-9) + 1;
    return true;
}

static bool read_derived(struct cfg_reader *r, config_setting_t *g, const struct spec *s,
                         struct spec_axis *axis)
{
    const char *text;
    config_setting_t *value = config_setting_get_member(g, "value");
    if (config_setting_type(value) != CONFIG_TYPE_STRING)
        return cfg_fail(
            r, value, axis->name,
            "value takes a formula, such as \"nodes / 4\"; numbers are given as values = ( ... )");
    axis->kind = SPEC_DERIVED;
    axis->count = 1;
    axis->numeric = true;
    axis->values = xcalloc(1, sizeof *axis->values);
    return cfg_text(r, g, "value", &text) && (axis->value = spec_expression(r, value, axis->name, text, s));
}

static bool read_values(struct cfg_reader *r, config_setting_t *g, const struct spec *s,
                        struct spec_axis *axis)
{
    config_setting_t *values = config_setting_get_member(g, "values"),
                     *cases = config_setting_get_member(g, "cases"), *list;
    if (!!values + !!cases + !!config_setting_get_member(g, "value") != 1)
        return cfg_fail(
            r, g, axis->name,
            "needs either values = ( ... ), values = { from ... }, value = \"...\" or cases = ( { ... } )");
    if (!values && !cases)
        return read_derived(r, g, s, axis);
    if (values && config_setting_is_group(values))
        return read_range(r, values, axis);
    return cfg_list(r, g, cases ? "cases" : "values", &list) && read_list(r, list, cases, axis);
}

/* Reads the settings and arguments that all values of an axis share. */
static bool read_templates(struct cfg_reader *r, config_setting_t *g, const struct spec *s,
                           struct spec_axis *axis)
{
    config_setting_t *set;
    const char *arguments, *when;
    if (!read_set(r, g, &set) || !spec_optional(r, g, "arguments", &arguments) ||
        !spec_optional(r, g, "when", &when))
        return false;
    if (*when && !(axis->when = spec_expression(r, config_setting_get_member(g, "when"), "when", when, s)))
        return false;
    for (size_t i = 0; i < (axis->kind == SPEC_LIST ? axis->count : 1); i++) {
        axis->values[i].set = set;
        axis->values[i].arguments = arguments;
    }
    return true;
}

/* --- all of them ---------------------------------------------------------------------------------------- */

static bool read_axis(struct cfg_reader *r, config_setting_t *g, struct spec *s)
{
    static const char *const of_values[] = {"name", "values", "value", "set", "arguments", "when", NULL};
    static const char *const of_cases[] = {"name", "cases", NULL};
    struct spec_axis *axis = &s->axes[s->axis_count];
    if (!config_setting_is_group(g))
        return cfg_fail(r, g, "axes", "must hold groups: { name = \"...\"; values = ( ... ); }");
    bool cases = config_setting_get_member(g, "cases");
    if (!cfg_text(r, g, "name", &axis->name) || !cfg_only(r, g, cases ? of_cases : of_values))
        return false;
    if (!spec_is_name(axis->name))
        return cfg_fail(r, g, "name", "\"%s\" is no name: letters, digits, _ - . are allowed", axis->name);
    if (spec_axis(s, axis->name))
        return cfg_fail(r, g, "name", "there is an axis %s already", axis->name);
    axis->at = g;
    bool read = read_values(r, g, s, axis);
    s->axis_count++; /* spec_free_axes() frees the axis even if it is wrong */
    if (!read || (!cases && !read_templates(r, g, s, axis)))
        return false;
    bool nodes = strcmp(axis->name, "nodes") == 0 && axis->kind != SPEC_DERIVED;
    for (size_t i = 0; nodes && i < axis->count; i++)
        if (!check_nodes(r, config_setting_get_member(g, cases ? "cases" : "values"), axis, i))
            return false;
    if (axis->count > SPEC_MAX_POINTS / s->product)
        return cfg_fail(r, g, axis->name, "makes more than %d points", SPEC_MAX_POINTS);
    s->product *= axis->count;
    return true;
}

/* Does the i'th axis change a run, itself or through an axis derived from it? */
static bool changes_something(const struct spec *s, size_t i)
{
    const struct spec_axis *axis = &s->axes[i];
    if (axis->kind == SPEC_DERIVED || strcmp(axis->name, "nodes") == 0 ||
        strcmp(axis->name, "machine") == 0 || config_setting_get_member(axis->at, "cases") ||
        axis->values[0].set || *axis->values[0].arguments)
        return true;
    for (size_t k = i + 1; k < s->axis_count; k++)
        if (s->axes[k].kind == SPEC_DERIVED && expr_uses(s->axes[k].value, i))
            return true;
    return false;
}

bool spec_read_axes(struct cfg_reader *r, struct spec *s)
{
    config_setting_t *list;
    s->product = 1;
    if (!config_setting_get_member(r->root, "axes"))
        return cfg_fail(r, r->root, "axes",
                        "missing: axes = ( { name = \"nodes\"; values = ( 1, 2, 4 ); } ); is a study of "
                        "1, 2 and 4 nodes");
    if (!cfg_list(r, r->root, "axes", &list))
        return false;
    int count = config_setting_length(list);
    if (count < 1 || count > SPEC_MAX_AXES)
        return cfg_fail(r, list, "axes", "%d axes: 1 to %d are allowed", count, SPEC_MAX_AXES);
    for (unsigned i = 0; i < (unsigned)count; i++)
        if (!read_axis(r, config_setting_get_elem(list, i), s))
            return false;
    for (size_t i = 0; i < s->axis_count; i++)
        if (!changes_something(s, i))
            return cfg_fail(r, s->axes[i].at, s->axes[i].name,
                            "changes nothing; give set = ( \"KEY={}\" ) or arguments = \"-option {}\"");
    return true;
}

void spec_free_axes(struct spec *s)
{
    for (size_t i = 0; i < s->axis_count; i++) {
        for (size_t k = 0; s->axes[i].kind == SPEC_LIST && k < s->axes[i].count; k++)
            free(s->axes[i].values[k].label);
        free(s->axes[i].values);
        expr_free(s->axes[i].value);
        expr_free(s->axes[i].when);
    }
}
