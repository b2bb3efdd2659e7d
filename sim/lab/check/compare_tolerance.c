/* compare_tolerance.c - see compare_tolerance.h. */
#include "lab/check/compare_tolerance.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Reads "1%" or "0.5". */
static bool read_amount(const char *text, struct compare_tolerance *t)
{
    char *end;
    t->allowed = strtod(text, &end);
    t->relative = *end == '%';
    if (end == text || end[t->relative] || !isfinite(t->allowed) || t->allowed < 0)
        return false;
    if (t->relative)
        t->allowed /= 100;
    return true;
}

static bool read_one(const char *text, struct compare_tolerance *t, char **why)
{
    const char *equals = strchr(text, '='), *amount = equals ? equals + 1 : text;
    *t = (struct compare_tolerance){0};
    if (equals == text || !read_amount(amount, t)) {
        *why = xasprintf("'%s' is no tolerance; write 0.5%%, total_s=1%% or messages=10", text);
        return false;
    }
    if (!equals && !t->relative && t->allowed != 0) {
        *why = xasprintf("'%s' has no unit that all figures share: %s%%, or FIGURE=%s", text, text, text);
        return false;
    }
    if (equals)
        t->figure = xasprintf("%.*s", (int)(equals - text), text);
    return true;
}

bool compare_rules_add(struct compare_rules *rules, const char *text, char **why)
{
    char *copy = xstrdup(text), *rest = copy, *one;
    bool good = true;
    while (good && (one = strsep(&rest, ","))) {
        rules->tolerances = xrealloc(rules->tolerances, (rules->count + 1) * sizeof *rules->tolerances);
        if ((good = read_one(one, &rules->tolerances[rules->count], why)))
            rules->count++;
    }
    free(copy);
    return good;
}

void compare_rules_clear(struct compare_rules *rules)
{
    for (size_t i = 0; i < rules->count; i++)
        free(rules->tolerances[i].figure);
    free(rules->tolerances);
    json_decref(rules->seen);
    *rules = (struct compare_rules){0};
}

void compare_rules_see(struct compare_rules *rules, const json_t *point)
{
    const char *name;
    json_t *value;
    if (!rules->seen)
        rules->seen = xchecked(json_object());
    json_object_foreach(json_object_get(point, "figures"), name, value)
        json_set(rules->seen, name, json_true());
}

static bool is_seen(const struct compare_rules *rules, const char *figure)
{
    return !figure || json_object_get(rules->seen, figure);
}

const char *compare_rules_unused(const struct compare_rules *rules)
{
    if (!is_seen(rules, rules->only))
        return rules->only;
    for (size_t i = 0; i < rules->count; i++)
        if (!is_seen(rules, rules->tolerances[i].figure))
            return rules->tolerances[i].figure;
    return NULL;
}

char *compare_rules_figures(const struct compare_rules *rules)
{
    const char *name, *before = "";
    json_t *value;
    char *text;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    json_object_foreach(rules->seen, name, value)
    {
        fprintf(f, "%s%s", before, name);
        before = ", ";
    }
    fclose(f);
    return text;
}
