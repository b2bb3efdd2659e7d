/* compare_tolerance.c - see compare_tolerance.h. */
#include "lab/check/compare_tolerance.h"
#include "kernel/xalloc.h"

#include <math.h>
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
    *rules = (struct compare_rules){0};
}

static bool is_there(const json_t *figures, const char *figure)
{
    return !figure || json_object_get(figures, figure);
}

const char *compare_rules_unused(const struct compare_rules *rules, const json_t *figures)
{
    if (!is_there(figures, rules->only))
        return rules->only;
    for (size_t i = 0; i < rules->count; i++)
        if (!is_there(figures, rules->tolerances[i].figure))
            return rules->tolerances[i].figure;
    return NULL;
}
