/* paper_fitted.c - reads the fitted cost factors, which the tables must name beside their figures; see paper.h. */
#include "config/reader.h"
#include "kernel/xalloc.h"
#include "lab/tables/paper.h"

#include <stdlib.h>
#include <string.h>

/* The member's text, malloc'd, or NULL when it is absent. */
static char *optional_text(config_setting_t *g, const char *key)
{
    const char *text;
    return config_setting_lookup_string(g, key, &text) == CONFIG_TRUE ? xstrdup(text) : NULL;
}

static bool read_factor(struct cfg_reader *r, config_setting_t *g, struct paper_factor *f)
{
    static const char *const keys[] = {"file", "function", "factor", "fitted_to", "note", NULL};
    const char *fitted_to;
    if (!config_setting_is_group(g))
        return cfg_fail(r, g, "factors", "must hold groups: { file = \"...\"; factor = ...; ... }");
    if (!cfg_only(r, g, keys) || !cfg_number(r, g, "factor", 0, 1000, &f->factor) ||
        !cfg_text(r, g, "fitted_to", &fitted_to))
        return false;
    f->fitted_to = xstrdup(fitted_to);
    f->file = optional_text(g, "file");
    f->function = optional_text(g, "function");
    return f->file || f->function || cfg_fail(r, g, "file", "missing; file or function must be given");
}

/* ( what, fitted to ), and then what else might have been chosen. */
static bool read_choice(struct cfg_reader *r, config_setting_t *s, const char *key, struct paper_choice *c)
{
    unsigned count = config_setting_is_list(s) ? (unsigned)config_setting_length(s) : 0;
    for (unsigned i = 0; i < count; i++)
        if (!config_setting_get_string_elem(s, i))
            count = 0;
    if (count < 2)
        return cfg_fail(r, s, key,
                        "must hold lists of texts: ( what, fitted to, and what else it might be )");
    c->what = xstrdup(config_setting_get_string_elem(s, 0));
    c->fitted_to = xstrdup(config_setting_get_string_elem(s, 1));
    c->instead_count = count - 2;
    c->instead = xcalloc(count - 1, sizeof *c->instead);
    for (unsigned i = 2; i < count; i++)
        c->instead[i - 2] = xstrdup(config_setting_get_string_elem(s, i));
    return true;
}

/* Adds a list of choices, if it is there. */
static bool read_choices(struct cfg_reader *r, const char *key, bool policy, struct paper_fitted *f)
{
    config_setting_t *list = config_setting_get_member(r->root, key);
    unsigned count = list ? (unsigned)config_setting_length(list) : 0;
    f->choices = xrealloc(f->choices, (f->choice_count + count + 1) * sizeof *f->choices);
    for (unsigned i = 0; i < count; i++) {
        struct paper_choice *c = &f->choices[f->choice_count];
        *c = (struct paper_choice){.policy = policy};
        if (!read_choice(r, config_setting_get_elem(list, i), key, c))
            return false;
        f->choice_count++;
    }
    return true;
}

static bool read_factors(struct cfg_reader *r, struct paper_fitted *f)
{
    static const char *const keys[] = {"factors", "constants", "policies", "fit", NULL};
    config_setting_t *list;
    if (!cfg_only(r, r->root, keys) || !cfg_list(r, r->root, "factors", &list))
        return false;
    f->count = (size_t)config_setting_length(list);
    f->factors = xcalloc(f->count + 1, sizeof *f->factors);
    for (unsigned i = 0; i < f->count; i++)
        if (!read_factor(r, config_setting_get_elem(list, i), &f->factors[i]))
            return false;
    return read_choices(r, "constants", false, f) && read_choices(r, "policies", true, f);
}

struct paper_fitted *paper_read_fitted(const char *path, char **error)
{
    struct cfg_reader r;
    struct paper_fitted *f = xcalloc(1, sizeof *f);
    bool ok = cfg_open(&r, path) && read_factors(&r, f);
    cfg_close(&r);
    if (ok)
        return f;
    *error = r.error;
    paper_free_fitted(f);
    return NULL;
}

void paper_free_fitted(struct paper_fitted *f)
{
    if (!f)
        return;
    for (size_t i = 0; i < f->count; i++) {
        free(f->factors[i].file);
        free(f->factors[i].function);
        free(f->factors[i].fitted_to);
    }
    for (size_t i = 0; i < f->choice_count; i++) {
        free(f->choices[i].what);
        free(f->choices[i].fitted_to);
        for (size_t k = 0; k < f->choices[i].instead_count; k++)
            free(f->choices[i].instead[k]);
        free(f->choices[i].instead);
    }
    free(f->choices);
    free(f->factors);
    free(f);
}
