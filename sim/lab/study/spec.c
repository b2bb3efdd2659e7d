/* spec.c - see spec.h. */
#include "lab/study/spec.h"
#include "kernel/xalloc.h"
#include "files/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool spec_optional(struct cfg_reader *r, config_setting_t *in, const char *key, const char **out)
{
    *out = "";
    return !config_setting_get_member(in, key) || cfg_text(r, in, key, out);
}

bool spec_is_name(const char *text)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
    return *text && !text[strspn(text, letters)];
}

const struct spec_axis *spec_axis(const struct spec *s, const char *name)
{
    for (size_t i = 0; i < s->axis_count; i++)
        if (strcmp(s->axes[i].name, name) == 0)
            return &s->axes[i];
    return NULL;
}

char *spec_no_axis(const struct spec *s, const char *name)
{
    char *text = xasprintf("there is no axis %s; there are: ", name);
    for (size_t i = 0; i < s->axis_count; i++)
        words_append(&text, "%s%s", i ? ", " : "", s->axes[i].name);
    return text;
}

size_t spec_axis_index(const struct spec *s, const struct spec_axis *axis)
{
    return (size_t)(axis - s->axes);
}

void spec_label(double number, char label[SPEC_MAX_LABEL])
{
    snprintf(label, SPEC_MAX_LABEL, fabs(number) < 1e15 && floor(number) == number ? "%.0f" : "%.12g",
             number);
}

double spec_value(const struct spec_axis *axis, size_t i, const char **text, char label[SPEC_MAX_LABEL])
{
    if (axis->kind == SPEC_LIST) {
        *text = axis->values[i].label;
        return axis->values[i].number;
    }
    spec_label(axis->times ? axis->from * pow(axis->step, (double)i) : axis->from + (double)i * axis->step,
               label);
    *text = label;
    return strtod(label, NULL); /* the number that the label says: 0.3, not 0.1 + 2 * 0.1 */
}

static const char *nth_text(void *arg, size_t i)
{
    const struct spec_axis *axis = arg;
    return i < axis->count ? axis->values[i].label : NULL;
}

struct expr *spec_expression(struct cfg_reader *r, config_setting_t *at, const char *key, const char *text,
                             const struct spec *s)
{
    struct expr_name names[SPEC_MAX_AXES];
    char *why = NULL;
    for (size_t i = 0; i < s->axis_count; i++)
        names[i] = (struct expr_name){s->axes[i].name, s->axes[i].numeric, nth_text, (void *)&s->axes[i]};
    struct expr *e = expr_read(text, names, s->axis_count, &why);
    if (!e)
        cfg_fail(r, at, key, "%s", why);
    free(why);
    return e;
}
