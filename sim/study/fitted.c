/* fitted.c - reads the fitted cost factors, which the tables must name beside their figures; see paper.h. */
#include "study/paper.h"
#include "config/reader.h"

#include <stdlib.h>
#include <string.h>

/* The member's text, malloc'd, or NULL when it is absent. */
static char *optional_text(config_setting_t *g, const char *key)
{
    const char *text;
    return config_setting_lookup_string(g, key, &text) == CONFIG_TRUE ? strdup(text) : NULL;
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
    f->fitted_to = strdup(fitted_to);
    f->file = optional_text(g, "file");
    f->function = optional_text(g, "function");
    return f->file || f->function || cfg_fail(r, g, "file", "missing; file or function must be given");
}

static bool read_factors(struct cfg_reader *r, struct paper_fitted *f)
{
    static const char *const keys[] = {"factors", NULL};
    config_setting_t *list;
    if (!cfg_only(r, r->root, keys) || !cfg_list(r, r->root, "factors", &list))
        return false;
    f->count = (size_t)config_setting_length(list);
    f->factors = calloc(f->count + 1, sizeof *f->factors);
    if (!f->factors)
        abort();
    for (unsigned i = 0; i < f->count; i++)
        if (!read_factor(r, config_setting_get_elem(list, i), &f->factors[i]))
            return false;
    return true;
}

struct paper_fitted *paper_read_fitted(const char *path, char **error)
{
    struct cfg_reader r;
    struct paper_fitted *f = calloc(1, sizeof *f);
    if (!f)
        abort();
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
    free(f->factors);
    free(f);
}
