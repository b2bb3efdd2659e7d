/* points.c - turns a point's number into values, and values into settings and arguments; see points.h. */
#include "lab/study/points.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/jobs/words.h"

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

enum point_is point_make(const struct spec *s, size_t number, struct point *p, char **error)
{
    size_t rest = number;
    p->number = number;
    for (size_t i = s->axis_count; i-- > 0;) {
        const struct spec_axis *axis = &s->axes[i];
        size_t at = digit(axis, &rest);
        p->value[i] = (struct expr_value){NAN, "?"};
        if (axis->kind != SPEC_DERIVED)
            p->value[i].number = spec_value(axis, at, &p->value[i].text, p->label[i]);
    }
    for (size_t i = 0; i < s->axis_count; i++)
        if (s->axes[i].kind == SPEC_DERIVED && !derive(s, p, i, error))
            return POINT_WRONG;
    for (size_t i = 0; i < s->only_count; i++) {
        double holds = expr_number(s->only[i], p->value);
        if (holds == 0 || isnan(holds))
            return POINT_LEFT_OUT;
    }
    return POINT_WANTED;
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
