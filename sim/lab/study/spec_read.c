/* spec_read.c - see spec_read.h. */
#include "lab/study/spec_read.h"
#include "config/config.h"
#include "kernel/xalloc.h"
#include "lab/study/spec_axes.h"
#include "lab/study/spec_pictures.h"

#include <stdlib.h>
#include <string.h>

static bool read_only(struct cfg_reader *r, struct spec *s)
{
    config_setting_t *list;
    if (!config_setting_get_member(r->root, "only"))
        return true;
    if (!cfg_list(r, r->root, "only", &list))
        return false;
    s->only = xcalloc((size_t)config_setting_length(list), sizeof *s->only);
    for (unsigned i = 0; i < (unsigned)config_setting_length(list); i++) {
        const char *text = config_setting_get_string_elem(list, (int)i);
        if (!text)
            return cfg_fail(r, list, "only", "must hold texts such as \"group <= nodes\"");
        struct expr *e = spec_expression(r, config_setting_get_elem(list, i), "only", text, s);
        if (!e)
            return false;
        s->only[s->only_count++] = e;
    }
    return true;
}

static bool read_inputs(struct cfg_reader *r, struct spec *s)
{
    config_setting_t *list = NULL;
    if (config_setting_get_member(r->root, "inputs") && !cfg_list(r, r->root, "inputs", &list))
        return false;
    size_t count = list ? (size_t)config_setting_length(list) : 0;
    s->inputs = xcalloc(count + 1, sizeof *s->inputs);
    for (size_t i = 0; i < count; i++)
        if (!(s->inputs[i] = config_setting_get_string_elem(list, (int)i)) || !*s->inputs[i])
            return cfg_fail(r, list, "inputs", "must hold names of files: ( \"volume.gz\" )");
    return true;
}

static bool has_value(const struct spec_axis *axis, const char *label)
{
    char own[SPEC_MAX_LABEL];
    const char *text;
    for (size_t i = 0; i < axis->count; i++) {
        spec_value(axis, i, &text, own);
        if (strcmp(text, label) == 0)
            return true;
    }
    return false;
}

/* Checks "AXIS=VALUE" or "AXIS" (lab/chart/speedup.h). */
static bool check_baseline(struct cfg_reader *r, config_setting_t *at, const struct spec *s, const char *text)
{
    const char *sign = strchr(text, '=');
    char *name = sign ? xasprintf("%.*s", (int)(sign - text), text) : xstrdup(text);
    const struct spec_axis *axis = spec_axis(s, name);
    char *none = axis ? NULL : spec_no_axis(s, name);
    bool ok = true;
    if (!axis)
        ok = cfg_fail(r, at, "baseline", "\"%s\": %s", text, none);
    else if (axis->kind == SPEC_DERIVED)
        ok = cfg_fail(r, at, "baseline", "\"%s\": %s follows from other axes: name one of them", text, name);
    else if (sign && !has_value(axis, sign + 1))
        ok = cfg_fail(r, at, "baseline", "\"%s\": axis %s has no value %s", text, name, sign + 1);
    free(none);
    free(name);
    return ok;
}

static bool read_baseline(struct cfg_reader *r, struct spec *s)
{
    config_setting_t *list;
    if (!config_setting_get_member(r->root, "baseline"))
        return true;
    if (!cfg_list(r, r->root, "baseline", &list))
        return false;
    s->baseline = xcalloc((size_t)config_setting_length(list) + 1, sizeof *s->baseline);
    for (unsigned i = 0; i < (unsigned)config_setting_length(list); i++) {
        s->baseline[i] = config_setting_get_string_elem(list, (int)i);
        if (!s->baseline[i])
            return cfg_fail(r, list, "baseline", "must hold texts such as \"group=8\", or names of axes");
        if (!check_baseline(r, config_setting_get_elem(list, i), s, s->baseline[i]))
            return false;
    }
    return true;
}

static bool read_limit(struct cfg_reader *r, const char *key, double *limit)
{
    return !config_setting_get_member(r->root, key) || cfg_number(r, r->root, key, 1e-9, 1e9, limit);
}

static bool read_unreceived(struct cfg_reader *r, struct spec *s)
{
    return !config_setting_get_member(r->root, "max_unreceived_mb") ||
           cfg_whole(r, r->root, "max_unreceived_mb", 1, 1 << 20, &s->max_unreceived_mb);
}

static bool read_cost(struct cfg_reader *r, struct spec *s)
{
    const char *text;
    if (!spec_optional(r, r->root, "cost", &text))
        return false;
    return !*text ||
           (s->cost = spec_expression(r, config_setting_get_member(r->root, "cost"), "cost", text, s));
}

static bool read_profile(struct cfg_reader *r, struct spec *s)
{
    config_setting_t *own = config_setting_get_member(r->root, "profile");
    if (own && config_setting_type(own) != CONFIG_TYPE_BOOL)
        return cfg_fail(r, own, "profile", "must be true or false");
    s->profile = own && config_setting_get_bool(own);
    return true;
}

/* The file gives nodes and machine, unless an axis does; else they are those of touchstone run. */
static bool read_nodes_and_machine(struct cfg_reader *r, struct spec *s)
{
    static const char *const either[] = {"nodes", "machine"};
    for (int i = 0; i < 2; i++) {
        config_setting_t *own = config_setting_get_member(r->root, either[i]);
        if (own && spec_axis(s, either[i]))
            return cfg_fail(r, own, either[i], "there is an axis of that name; give only one of the two");
    }
    s->machine = spec_axis(s, "machine") ? "" : CFG_USUAL_MACHINE;
    s->nodes = !spec_axis(s, "nodes");
    return (!config_setting_get_member(r->root, "nodes") ||
            cfg_whole(r, r->root, "nodes", 1, SPEC_MAX_NODES, &s->nodes)) &&
           (!config_setting_get_member(r->root, "machine") || cfg_text(r, r->root, "machine", &s->machine));
}

static bool read_spec(struct cfg_reader *r, struct spec *s)
{
    static const char *const keys[] = {
        "title",   "about",    "program", "machine",  "nodes",      "arguments",     "inputs",
        "axes",    "only",     "cost",    "baseline", "max_wall_s", "max_virtual_s", "max_unreceived_mb",
        "profile", "pictures", "fit",     NULL};
    return cfg_only(r, r->root, keys) && cfg_text(r, r->root, "program", &s->program) &&
           spec_optional(r, r->root, "title", &s->title) && spec_optional(r, r->root, "about", &s->about) &&
           spec_optional(r, r->root, "arguments", &s->arguments) && read_inputs(r, s) &&
           spec_read_axes(r, s) && read_nodes_and_machine(r, s) && read_only(r, s) && read_cost(r, s) &&
           read_baseline(r, s) && read_limit(r, "max_wall_s", &s->max_wall_s) &&
           read_limit(r, "max_virtual_s", &s->max_virtual_s) && read_unreceived(r, s) && read_profile(r, s) &&
           spec_read_pictures(r, s);
}

struct spec *spec_read(const char *path, char **error)
{
    struct spec *s = xcalloc(1, sizeof *s);
    s->path = path;
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
    spec_free_axes(s);
    for (size_t i = 0; i < s->only_count; i++)
        expr_free(s->only[i]);
    free(s->only);
    expr_free(s->cost);
    free(s->inputs);
    free(s->baseline);
    free(s->pictures);
    cfg_close(&s->reader);
    free(s);
}
