/* spec_pictures.c - see spec_pictures.h. */
#include "lab/study/spec_pictures.h"
#include "kernel/xalloc.h"

#include <stdlib.h>
#include <string.h>

/* Reads the axis that the key names; "" if the key is missing. */
static bool read_axis_of(struct cfg_reader *r, config_setting_t *g, const char *key, const struct spec *s,
                         const char **name)
{
    if (!spec_optional(r, g, key, name))
        return false;
    if (!**name || spec_axis(s, *name))
        return true;
    char *none = spec_no_axis(s, *name);
    cfg_fail(r, config_setting_get_member(g, key), key, "%s", none);
    free(none);
    return false;
}

/* A picture must use each axis of several values exactly once; otherwise it would show an arbitrary part of
 * the points. */
static bool check_picture(struct cfg_reader *r, config_setting_t *g, const struct spec *s,
                          const struct picture *p)
{
    const char *const places[] = {p->x, p->lines, p->panels, p->best, p->ratio};
    for (size_t i = 0; i < s->axis_count; i++) {
        const struct spec_axis *axis = &s->axes[i];
        int used = 0;
        for (size_t k = 0; k < sizeof places / sizeof *places; k++)
            used += strcmp(places[k], axis->name) == 0;
        if (used > 1)
            return cfg_fail(r, g, p->file,
                            "axis %s is given %d times as x, lines, panels, best or ratio; once is allowed",
                            axis->name, used);
        if (used == 0 && axis->count > 1)
            return cfg_fail(r, g, p->file, "axis %s must be x, lines, panels, best or ratio", axis->name);
        if (strcmp(p->ratio, axis->name) == 0 && axis->count != 2)
            return cfg_fail(r, g, "ratio", "axis %s has %zu values; a ratio needs two", axis->name,
                            axis->count);
    }
    return true;
}

static bool read_picture(struct cfg_reader *r, config_setting_t *g, const struct spec *s, struct picture *p)
{
    static const char *const keys[] = {"file",        "title",   "x",           "y",
                                       "lines",       "panels",  "best",        "least",
                                       "x_label",     "y_label", "lines_label", "panels_label",
                                       "logarithmic", "ranges",  "ratio",       NULL};
    const char *log, *ranges;
    if (!config_setting_is_group(g))
        return cfg_fail(r, g, "pictures", "must hold groups: { file = \"...\"; x = \"...\"; y = \"...\"; }");
    bool best = config_setting_get_member(g, "best");
    if (!cfg_only(r, g, keys) || !cfg_text(r, g, "file", &p->file) ||
        !spec_optional(r, g, "title", &p->title) || !read_axis_of(r, g, "x", s, &p->x) ||
        !read_axis_of(r, g, "lines", s, &p->lines) || !read_axis_of(r, g, "panels", s, &p->panels) ||
        !read_axis_of(r, g, "best", s, &p->best) || !read_axis_of(r, g, "ratio", s, &p->ratio) ||
        !cfg_text(r, g, best ? "least" : "y", &p->figure) || !spec_optional(r, g, "x_label", &p->x_label) ||
        !spec_optional(r, g, "y_label", &p->y_label) ||
        !spec_optional(r, g, "lines_label", &p->lines_label) ||
        !spec_optional(r, g, "panels_label", &p->panels_label) || !spec_optional(r, g, "logarithmic", &log) ||
        !spec_optional(r, g, "ranges", &ranges))
        return false;
    if (!*p->x)
        return cfg_fail(r, g, "x", "missing");
    if (*p->best && *p->ratio)
        return cfg_fail(r, g, "ratio", "cannot be drawn of the best: give only one of the two");
    if (!spec_is_name(p->file))
        return cfg_fail(r, g, "file", "\"%s\" is no name: letters, digits, _ - . are allowed", p->file);
    if (log[strspn(log, "xy")])
        return cfg_fail(r, g, "logarithmic", "must be \"x\", \"y\" or \"xy\"");
    if (*ranges && strcmp(ranges, "same") != 0 && strcmp(ranges, "own") != 0)
        return cfg_fail(r, g, "ranges", "must be \"same\" (the panels' ranges of y; the default) or \"own\"");
    p->own_ranges = strcmp(ranges, "own") == 0;
    p->log_x = strchr(log, 'x');
    p->log_y = strchr(log, 'y');
    return check_picture(r, g, s, p);
}

bool spec_read_pictures(struct cfg_reader *r, struct spec *s)
{
    config_setting_t *list;
    if (!config_setting_get_member(r->root, "pictures"))
        return true;
    if (!cfg_list(r, r->root, "pictures", &list))
        return false;
    s->picture_count = (size_t)config_setting_length(list);
    s->pictures = xcalloc(s->picture_count, sizeof *s->pictures);
    for (unsigned i = 0; i < s->picture_count; i++)
        if (!read_picture(r, config_setting_get_elem(list, i), s, &s->pictures[i]))
            return false;
    return true;
}
