/* spec.c - reads a study file; see spec.h. */
#include "study/spec.h"
#include "study/condition.h"
#include "study/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char name_letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";

static void *zeroed(size_t count, size_t size)
{
    void *p = calloc(count + 1, size);
    if (!p)
        abort();
    return p;
}

/* The text of that key, or "" when it is not there. */
static bool optional_text(struct cfg_reader *r, config_setting_t *in, const char *key, const char **out)
{
    *out = "";
    return !config_setting_get_member(in, key) || cfg_text(r, in, key, out);
}

const struct spec_axis *spec_axis(const struct spec *s, const char *name)
{
    for (size_t i = 0; i < s->axis_count; i++)
        if (strcmp(s->axes[i].name, name) == 0)
            return &s->axes[i];
    return NULL;
}

size_t spec_place(const struct spec *s, const struct spec_axis *axis)
{
    return (size_t)(axis - s->axes);
}

/* --- axes ------------------------------------------------------------------------------------------------ */

/* A list of texts KEY=VALUE; *out stays NULL if there is none. */
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

/* A number or a text, as it stands in a list of values. */
static bool read_plain(struct cfg_reader *r, config_setting_t *s, struct spec_value *value)
{
    switch (config_setting_type(s)) {
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64:
        value->number = (double)config_setting_get_int64(s);
        value->label = text_of("%lld", config_setting_get_int64(s));
        return true;
    case CONFIG_TYPE_FLOAT:
        value->number = config_setting_get_float(s);
        value->label = text_of("%g", value->number);
        return true;
    case CONFIG_TYPE_STRING:
        value->number = NAN;
        value->label = strdup(config_setting_get_string(s));
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
        !optional_text(r, g, "arguments", &value->arguments))
        return false;
    value->label = strdup(label);
    value->number = NAN;
    return true;
}

/* What the values of an axis do is said once, for all of them. */
static bool read_templates(struct cfg_reader *r, config_setting_t *g, struct spec_axis *axis)
{
    config_setting_t *set;
    const char *arguments;
    bool known = strcmp(axis->name, "nodes") == 0 || strcmp(axis->name, "machine") == 0;
    if (!read_set(r, g, &set) || !optional_text(r, g, "arguments", &arguments))
        return false;
    if (!known && !set && !*arguments)
        return cfg_fail(r, g, axis->name,
                        "changes nothing; give set = ( \"KEY={}\" ) or arguments = \"-option {}\"");
    for (size_t i = 0; i < axis->count; i++) {
        axis->values[i].set = set;
        axis->values[i].arguments = arguments;
    }
    return true;
}

static bool check_values(struct cfg_reader *r, config_setting_t *list, const struct spec_axis *axis)
{
    for (unsigned i = 0; i < axis->count; i++) {
        const struct spec_value *value = &axis->values[i];
        bool whole =
            value->number >= 1 && value->number <= SPEC_MAX_NODES && floor(value->number) == value->number;
        if (strcmp(axis->name, "nodes") == 0 && !whole)
            return cfg_fail(r, list, "nodes", "%s is not a number of nodes: whole, from 1 to %d",
                            value->label, SPEC_MAX_NODES);
        for (unsigned k = 0; k < i; k++)
            if (strcmp(axis->values[k].label, value->label) == 0)
                return cfg_fail(r, list, axis->name, "%s is there twice", value->label);
    }
    return true;
}

static bool read_values(struct cfg_reader *r, config_setting_t *g, struct spec_axis *axis)
{
    bool cases = config_setting_get_member(g, "cases");
    config_setting_t *list;
    if (cases == !!config_setting_get_member(g, "values"))
        return cfg_fail(r, g, axis->name, "needs either values = ( ... ) or cases = ( { ... } )");
    if (!cfg_list(r, g, cases ? "cases" : "values", &list))
        return false;
    axis->count = (size_t)config_setting_length(list);
    axis->values = zeroed(axis->count, sizeof *axis->values);
    axis->numeric = true;
    for (unsigned i = 0; i < axis->count; i++) {
        config_setting_t *s = config_setting_get_elem(list, i);
        if (!(cases ? read_case : read_plain)(r, s, &axis->values[i]))
            return false;
        axis->numeric &= !isnan(axis->values[i].number);
    }
    if (!axis->count)
        return cfg_fail(r, list, axis->name, "is empty: at least one value is needed");
    return check_values(r, list, axis) && (cases || read_templates(r, g, axis));
}

static bool read_axis(struct cfg_reader *r, config_setting_t *g, struct spec *s)
{
    static const char *const of_values[] = {"name", "values", "set", "arguments", NULL};
    static const char *const of_cases[] = {"name", "cases", NULL};
    struct spec_axis *axis = &s->axes[s->axis_count];
    if (!config_setting_is_group(g))
        return cfg_fail(r, g, "axes", "must hold groups: { name = \"...\"; values = ( ... ); }");
    if (!cfg_text(r, g, "name", &axis->name) ||
        !cfg_only(r, g, config_setting_get_member(g, "cases") ? of_cases : of_values))
        return false;
    if (axis->name[strspn(axis->name, name_letters)])
        return cfg_fail(r, g, "name", "\"%s\" is no name: letters, digits, _ - . are allowed", axis->name);
    if (spec_axis(s, axis->name))
        return cfg_fail(r, g, "name", "there is an axis %s already", axis->name);
    s->axis_count++;
    return read_values(r, g, axis);
}

static bool read_axes(struct cfg_reader *r, struct spec *s)
{
    config_setting_t *list;
    if (!cfg_list(r, r->root, "axes", &list))
        return false;
    int count = config_setting_length(list);
    if (count < 1 || count > SPEC_MAX_AXES)
        return cfg_fail(r, list, "axes", "%d axes: 1 to %d are allowed", count, SPEC_MAX_AXES);
    for (unsigned i = 0; i < (unsigned)count; i++)
        if (!read_axis(r, config_setting_get_elem(list, i), s))
            return false;
    return true;
}

/* --- conditions and pictures ----------------------------------------------------------------------------- */

static bool read_only(struct cfg_reader *r, struct spec *s)
{
    config_setting_t *list;
    char *why;
    if (!config_setting_get_member(r->root, "only"))
        return true;
    if (!cfg_list(r, r->root, "only", &list))
        return false;
    s->only = zeroed((size_t)config_setting_length(list), sizeof *s->only);
    for (unsigned i = 0; i < (unsigned)config_setting_length(list); i++) {
        const char *text = config_setting_get_string_elem(list, (int)i);
        if (!text)
            return cfg_fail(r, list, "only", "must hold texts such as \"group <= nodes\"");
        if (!condition_read(&s->only[s->only_count++], text, s, &why)) {
            cfg_fail(r, config_setting_get_elem(list, i), "only", "%s", why);
            free(why);
            return false;
        }
    }
    return true;
}

/* The axis that the key names; NULL when there is no such key. */
static bool read_axis_of(struct cfg_reader *r, config_setting_t *g, const char *key, const struct spec *s,
                         const struct spec_axis **axis)
{
    const char *name;
    if (!optional_text(r, g, key, &name))
        return false;
    *axis = *name ? spec_axis(s, name) : NULL;
    return *axis || !*name ||
           cfg_fail(r, config_setting_get_member(g, key), key, "there is no axis %s", name);
}

/* Each axis of more than one value has its place in a picture, or the picture is of an arbitrary part. */
static bool check_picture(struct cfg_reader *r, config_setting_t *g, const struct spec *s,
                          const struct spec_picture *p)
{
    for (size_t i = 0; i < s->axis_count; i++) {
        const struct spec_axis *axis = &s->axes[i];
        int places = (axis == p->x) + (axis == p->lines) + (axis == p->panels) + (axis == p->best);
        if (places > 1)
            return cfg_fail(r, g, p->file, "axis %s has %d places of x, lines, panels, best; one is allowed",
                            axis->name, places);
        if (places == 0 && axis->count > 1)
            return cfg_fail(r, g, p->file, "axis %s has no place: x, lines, panels and best are to be had",
                            axis->name);
    }
    return true;
}

static bool read_picture(struct cfg_reader *r, config_setting_t *g, const struct spec *s,
                         struct spec_picture *p)
{
    static const char *const keys[] = {"file", "title", "x",       "y",       "lines",       "panels",
                                       "best", "least", "x_label", "y_label", "logarithmic", NULL};
    const char *log;
    if (!config_setting_is_group(g))
        return cfg_fail(r, g, "pictures", "must hold groups: { file = \"...\"; x = \"...\"; y = \"...\"; }");
    bool best = config_setting_get_member(g, "best");
    if (!cfg_only(r, g, keys) || !cfg_text(r, g, "file", &p->file) ||
        !optional_text(r, g, "title", &p->title) || !read_axis_of(r, g, "x", s, &p->x) ||
        !read_axis_of(r, g, "lines", s, &p->lines) || !read_axis_of(r, g, "panels", s, &p->panels) ||
        !read_axis_of(r, g, "best", s, &p->best) || !cfg_text(r, g, best ? "least" : "y", &p->figure) ||
        !optional_text(r, g, "x_label", &p->x_label) || !optional_text(r, g, "y_label", &p->y_label) ||
        !optional_text(r, g, "logarithmic", &log))
        return false;
    if (!p->x)
        return cfg_fail(r, g, "x", "missing");
    if (p->file[strspn(p->file, name_letters)])
        return cfg_fail(r, g, "file", "\"%s\" is no name: letters, digits, _ - . are allowed", p->file);
    if (log[strspn(log, "xy")])
        return cfg_fail(r, g, "logarithmic", "must be \"x\", \"y\" or \"xy\"");
    p->log_x = strchr(log, 'x') && p->x->numeric;
    p->log_y = strchr(log, 'y') && (!p->best || p->best->numeric);
    return check_picture(r, g, s, p);
}

static bool read_pictures(struct cfg_reader *r, struct spec *s)
{
    config_setting_t *list;
    if (!config_setting_get_member(r->root, "pictures"))
        return true;
    if (!cfg_list(r, r->root, "pictures", &list))
        return false;
    s->picture_count = (size_t)config_setting_length(list);
    s->pictures = zeroed(s->picture_count, sizeof *s->pictures);
    for (unsigned i = 0; i < s->picture_count; i++)
        if (!read_picture(r, config_setting_get_elem(list, i), s, &s->pictures[i]))
            return false;
    return true;
}

/* --- the whole ------------------------------------------------------------------------------------------- */

/* What an axis may have instead of the file as a whole. */
static bool read_nodes_and_machine(struct cfg_reader *r, struct spec *s)
{
    static const char *const either[] = {"nodes", "machine"};
    for (int i = 0; i < 2; i++) {
        config_setting_t *own = config_setting_get_member(r->root, either[i]);
        if (own && spec_axis(s, either[i]))
            return cfg_fail(r, own, either[i], "an axis has it: one of them only");
    }
    s->machine = "";
    return (spec_axis(s, "nodes") || cfg_whole(r, r->root, "nodes", 1, SPEC_MAX_NODES, &s->nodes)) &&
           (spec_axis(s, "machine") || cfg_text(r, r->root, "machine", &s->machine));
}

static bool read_spec(struct cfg_reader *r, struct spec *s)
{
    static const char *const keys[] = {"title", "program", "machine",  "nodes", "arguments",
                                       "axes",  "only",    "pictures", NULL};
    return cfg_only(r, r->root, keys) && cfg_text(r, r->root, "program", &s->program) &&
           optional_text(r, r->root, "title", &s->title) &&
           optional_text(r, r->root, "arguments", &s->arguments) && read_axes(r, s) &&
           read_nodes_and_machine(r, s) && read_only(r, s) && read_pictures(r, s);
}

struct spec *spec_read(const char *path, char **error)
{
    struct spec *s = zeroed(1, sizeof *s);
    if (cfg_open(&s->reader, path) && read_spec(&s->reader, s))
        return s;
    *error = s->reader.error;
    spec_free(s);
    return NULL;
}

void spec_free(struct spec *s)
{
    if (!s)
        return;
    for (size_t i = 0; i < s->axis_count; i++) {
        for (size_t k = 0; k < s->axes[i].count; k++)
            free(s->axes[i].values[k].label);
        free(s->axes[i].values);
    }
    for (size_t i = 0; i < s->only_count; i++)
        condition_clear(&s->only[i]);
    free(s->only);
    free(s->pictures);
    cfg_close(&s->reader);
    free(s);
}
