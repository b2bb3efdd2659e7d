/* fit_read.c - reads the fit of a study file: parameters and measurements; see fit.h. */
#include "files/number.h"
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"
#include "lab/jobs/outcome.h"
#include "files/words.h"
#include "lab/study/spec_read.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- parameters ----------------------------------------------------------------------------------------- */

static bool read_logarithmic(struct cfg_reader *r, config_setting_t *g, struct fit_parameter *p)
{
    config_setting_t *own = config_setting_get_member(g, "logarithmic");
    if (own && config_setting_type(own) != CONFIG_TYPE_BOOL)
        return cfg_fail(r, own, "logarithmic", "must be true or false");
    p->logarithmic = own && config_setting_get_bool(own);
    return !p->logarithmic || p->from > 0 ||
           cfg_fail(r, g, "logarithmic", "needs a range above 0, not from %g", p->from);
}

static bool read_template(struct cfg_reader *r, config_setting_t *g, const char *key, const char **text)
{
    if (!config_setting_get_member(g, key))
        return true;
    return cfg_text(r, g, key, text) &&
           (strstr(*text, "{}") ||
            cfg_fail(r, config_setting_get_member(g, key), key, "must have {} where the number belongs"));
}

static bool read_parameter(struct cfg_reader *r, config_setting_t *g, struct fit_parameter *p)
{
    static const char *const keys[] = {"name", "set",   "arguments",   "factor", "from",
                                       "to",   "start", "logarithmic", NULL};
    *p = (struct fit_parameter){0};
    if (!config_setting_is_group(g))
        return cfg_fail(r, g, "parameters",
                        "must hold groups: { name = \"...\"; set = \"KEY={}\"; from = ...; to = ...; }");
    if (!cfg_only(r, g, keys) || !cfg_text(r, g, "name", &p->name) || !read_template(r, g, "set", &p->set) ||
        !read_template(r, g, "arguments", &p->arguments) ||
        !cfg_number(r, g, "from", -1e15, 1e15, &p->from) || !cfg_number(r, g, "to", -1e15, 1e15, &p->to))
        return false;
    if (config_setting_get_member(g, "factor") && !cfg_text(r, g, "factor", &p->factor))
        return false;
    if (!!p->set + !!p->arguments + !!p->factor != 1)
        return cfg_fail(
            r, g, p->name,
            "needs one of set, a machine's KEY={}, arguments of the program, factor, a source file");
    if (!(p->from < p->to))
        return cfg_fail(r, g, "from", "%g must be less than to, %g", p->from, p->to);
    if (!read_logarithmic(r, g, p))
        return false;
    p->start = fit_value(p, 0.5);
    return !config_setting_get_member(g, "start") || cfg_number(r, g, "start", p->from, p->to, &p->start);
}

static bool read_parameters(struct cfg_reader *r, config_setting_t *in, struct fit *f)
{
    config_setting_t *list;
    if (!cfg_list(r, in, "parameters", &list))
        return false;
    f->parameters = (size_t)config_setting_length(list);
    if (f->parameters < 1 || f->parameters > FIT_MAX_NUMBERS)
        return cfg_fail(r, list, "parameters", "must hold 1 to %d groups", FIT_MAX_NUMBERS);
    for (unsigned i = 0; i < f->parameters; i++)
        if (!read_parameter(r, config_setting_get_elem(list, i), &f->parameter[i]))
            return false;
    return true;
}

/* --- measurements --------------------------------------------------------------------------------------- */

/* The cells of axes. NULL with *error if an axis of several values has none. */
static json_t *axes_of(const struct fit *f, const json_t *cells, const char *at, char **error)
{
    json_t *where = json_object();
    for (size_t i = 0; i < f->spec->axis_count; i++) {
        const struct spec_axis *axis = &f->spec->axes[i];
        json_t *cell = json_object_get(cells, axis->name);
        if (cell) {
            json_object_set(where, axis->name, cell);
        } else if (axis->count > 1) {
            *error = xasprintf("%s: which %s? The measurements have no column of that name", at, axis->name);
            json_decref(where);
            return NULL;
        }
    }
    return where;
}

static char *name_of(const json_t *where, const char *figure)
{
    char *name = xstrdup("");
    const char *axis;
    json_t *value;
    json_object_foreach((json_t *)where, axis, value)
        words_append(&name, "%s%s %s", *name ? ", " : "", axis, json_string_value(value));
    words_append(&name, "%s%s", *name ? ": " : "", figure);
    return name;
}

static bool add(struct fit *f, const json_t *where, const char *figure, const char *text, double weight,
                const char *at, char **error)
{
    struct fit_measurement m = {0};
    double unit;
    if (!number_read(text, &m.value, &unit)) {
        *error = xasprintf("%s: %s: '%s' is no number", at, figure, text);
        return false;
    }
    if (!f->by_rounding && m.value == 0) {
        *error =
            xasprintf("%s: %s is 0, and has no relative error: weights = \"rounding\" has one", at, figure);
        return false;
    }
    m.half = unit / 2;
    m.scale = (f->by_rounding ? m.half : 0.01 * fabs(m.value)) / weight;
    assert(m.scale > 0);
    m.name = name_of(where, figure);
    m.figure = xstrdup(figure);
    m.where = json_incref((json_t *)where);
    m.at = xstrdup(at);
    f->measurement = xrealloc(f->measurement, (f->measurements + 1) * sizeof m);
    f->measurement[f->measurements++] = m;
    return true;
}

static bool add_row(void *arg, const json_t *cells, const char *at, char **error)
{
    struct fit *f = arg;
    const char *column, *weight_text = json_string_value(json_object_get(cells, "weight"));
    double weight = 1;
    json_t *cell;
    bool good = true;
    if (weight_text && (!number_read(weight_text, &weight, NULL) || weight <= 0)) {
        *error = xasprintf("%s: weight: '%s' is no number above 0", at, weight_text);
        return false;
    }
    json_t *where = axes_of(f, cells, at, error);
    if (!where)
        return false;
    json_object_foreach((json_t *)cells, column,
                        cell) if (good && !spec_axis(f->spec, column) && strcmp(column, "weight") != 0) good =
        add(f, where, column, json_string_value(cell), weight, at, error);
    json_decref(where);
    return good;
}

/* A setting's value as text, malloc'd; NULL if it is neither text nor number. */
static char *text_of_setting(const config_setting_t *s)
{
    switch (config_setting_type(s)) {
    case CONFIG_TYPE_STRING:
        return xstrdup(config_setting_get_string(s));
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64:
        return xasprintf("%lld", config_setting_get_int64(s));
    case CONFIG_TYPE_FLOAT:
        return xasprintf("%.15g", config_setting_get_float(s));
    default:
        return NULL;
    }
}

static bool add_group(struct cfg_reader *r, config_setting_t *g, struct fit *f, char **error)
{
    json_t *cells = json_object();
    char *at = xasprintf("%s:%u", f->options->study.file, (unsigned)config_setting_source_line(g));
    bool good = config_setting_is_group(g) ||
                cfg_fail(r, g, "measurements", "must hold groups: { nodes = 2; total_s = 0.015; }");
    for (unsigned i = 0; good && i < (unsigned)config_setting_length(g); i++) {
        config_setting_t *member = config_setting_get_elem(g, i);
        char *text = text_of_setting(member);
        good = text || cfg_fail(r, member, config_setting_name(member), "must be a number or a text");
        if (text)
            json_object_set_new(cells, config_setting_name(member), json_string(text));
        free(text);
    }
    good = good && add_row(f, cells, at, error);
    json_decref(cells);
    free(at);
    return good;
}

/* The path of name relative to the study file; malloc'd. */
static char *beside(const char *study, const char *name)
{
    const char *slash = strrchr(study, '/');
    return *name == '/' || !slash ? xstrdup(name) : xasprintf("%.*s/%s", (int)(slash - study), study, name);
}

static bool read_measurements(struct cfg_reader *r, config_setting_t *in, struct fit *f, char **error)
{
    config_setting_t *own = config_setting_get_member(in, "measurements");
    const char *file = own ? config_setting_get_string(own) : NULL;
    f->data = file ? file : f->options->study.file;
    if (file) {
        char *path = beside(f->options->study.file, file);
        bool good = fit_table(path, add_row, f, error);
        free(path);
        if (!good)
            return false;
    } else {
        config_setting_t *list;
        if (!cfg_list(r, in, "measurements", &list))
            return false;
        for (unsigned i = 0; i < (unsigned)config_setting_length(list); i++)
            if (!add_group(r, config_setting_get_elem(list, i), f, error))
                return false;
    }
    return f->measurements || cfg_fail(r, own, "measurements", "has none");
}

/* --- the whole ------------------------------------------------------------------------------------------ */

static bool read_weights(struct cfg_reader *r, config_setting_t *in, struct fit *f)
{
    const char *text;
    if (!spec_optional(r, in, "weights", &text))
        return false;
    f->by_rounding = strcmp(text, "rounding") == 0;
    return f->by_rounding || !*text || strcmp(text, "relative") == 0 ||
           cfg_fail(r, config_setting_get_member(in, "weights"), "weights",
                    "must be \"relative\" or \"rounding\"");
}

/* Reads the build command, which is needed if a parameter is a factor. */
static bool read_build(struct cfg_reader *r, config_setting_t *in, struct fit *f)
{
    bool factors = false;
    for (size_t i = 0; i < f->parameters; i++)
        factors |= f->parameter[i].factor != NULL;
    if (!factors && !config_setting_get_member(in, "build"))
        return true;
    if (!cfg_text(r, in, "build", &f->build))
        return false;
    return (strstr(f->build, "{factors}") && strstr(f->build, "{program}")) ||
           cfg_fail(r, config_setting_get_member(in, "build"), "build",
                    "must have {factors} and {program}: nxcc -O2 --factors {factors} -o {program} prog.c");
}

bool fit_read(struct fit *f, char **error)
{
    static const char *const keys[] = {"parameters", "measurements", "weights", "build", NULL};
    if (!(f->spec = spec_read(f->options->study.file, error)))
        return false;
    struct cfg_reader *r = &f->spec->reader;
    config_setting_t *in = NULL;
    if (!config_setting_get_member(r->root, "fit")) {
        *error = xasprintf("%s: there is no group fit, which says what to fit to which measurements "
                           "(touchstone fit --help shows one)",
                           f->options->study.file);
        return false;
    }
    bool good = cfg_group(r, r->root, "fit", &in) && cfg_only(r, in, keys) && read_weights(r, in, f) &&
                read_parameters(r, in, f) && read_build(r, in, f) && read_measurements(r, in, f, error);
    if (!good && !*error) {
        *error = r->error;
        r->error = NULL;
    }
    return good;
}

void fit_clear(struct fit *f)
{
    for (size_t i = 0; i < f->measurements; i++) {
        struct fit_measurement *m = &f->measurement[i];
        json_decref(m->where);
        free(m->name);
        free(m->figure);
        free(m->at);
    }
    free(f->measurement);
    free(f->computed);
    words_free(f->failed);
    free(f->built);
    free(f->program);
    free(f->error);
    spec_free(f->spec);
}
