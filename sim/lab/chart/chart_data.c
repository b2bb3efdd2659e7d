/* chart_data.c - takes what a picture draws from the results, in one pass over the points; see chart_data.h.
 *
 * The value at a position (panel, line, x) is the figure of the point there. If the picture has an axis
 * `best`, several points share the position, and the value is that axis's value at the point with the least
 * figure. If it has an axis `ratio`, two points share the position, and the value is the second's figure
 * divided by the first's.
 */
#include "lab/chart/chart_data.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/chart/record.h"
#include "lab/jobs/outcome.h"
#include "files/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct taker {
    const struct picture *picture;
    struct chart_data *data;
    double *least; /* the least figure so far at each position; of a ratio, the figure to divide by */
    json_t *fixed; /* axes that the picture does not use: their first values */
};

char *chart_label(const json_t *value)
{
    if (json_is_string(value))
        return xstrdup(json_string_value(value));
    return json_is_integer(value) ? xasprintf("%lld", json_integer_value(value))
                                  : xasprintf("%.12g", json_number_value(value));
}

static void take_axis(const json_t *values, const char *name, struct chart_axis *a)
{
    size_t count = *name ? json_array_size(values) : 1;
    *a = (struct chart_axis){.name = name, .count = count, .numeric = *name, .index = json_object()};
    a->label = xcalloc(count, sizeof *a->label);
    a->position = xcalloc(count, sizeof *a->position);
    for (size_t i = 0; i < count; i++) {
        const json_t *value = json_array_get(values, i);
        a->label[i] = *name ? chart_label(value) : xstrdup("");
        a->numeric &= json_is_number(value);
        json_set(a->index, a->label[i], json_integer((json_int_t)i));
    }
    for (size_t i = 0; i < count; i++)
        a->position[i] = a->numeric ? json_number_value(json_array_get(values, i)) : (double)(i + 1);
}

/* The index of the point's value on the axis; count if the axis has no such value. */
static size_t index_on(const struct chart_axis *a, const json_t *point)
{
    if (!*a->name)
        return 0;
    char *label = chart_label(json_object_get(point, a->name));
    json_t *index = json_object_get(a->index, label);
    free(label);
    return index ? (size_t)json_integer_value(index) : a->count;
}

static bool is_beside(const struct taker *t, const json_t *point)
{
    const char *name;
    json_t *value;
    json_object_foreach(t->fixed, name,
                        value) if (!json_equal(json_object_get(point, name), value)) return true;
    return false;
}

static bool take_point(void *arg, const json_t *point, char **error)
{
    struct taker *t = arg;
    struct chart_data *d = t->data;
    double figure = figure_of(point, t->picture->figure);
    size_t panel = index_on(&d->panels, point), line = index_on(&d->lines, point), x = index_on(&d->x, point),
           best = index_on(&d->best, point), ratio = index_on(&d->ratio, point);
    (void)error;
    if (isnan(figure) || panel == d->panels.count || line == d->lines.count || x == d->x.count ||
        best == d->best.count || ratio == d->ratio.count || is_beside(t, point))
        return true;
    size_t cell = (panel * d->lines.count + line) * d->x.count + x;
    if (*d->ratio.name)
        (ratio ? d->drawn : t->least)[cell] = figure;
    else if (!(figure >= t->least[cell])) {
        t->least[cell] = figure;
        d->drawn[cell] = *d->best.name ? d->best.position[best] : figure;
    }
    return true;
}

static bool take_axes(const struct record_points *points, const struct picture *p, struct chart_data *d,
                      char **error)
{
    json_t *axes = json_object_get(points->header, "axes");
    const char *const names[] = {p->x, p->lines, p->panels, p->best, p->ratio};
    struct chart_axis *const axes_of[] = {&d->x, &d->lines, &d->panels, &d->best, &d->ratio};
    enum { PLACES = sizeof names / sizeof *names };
    for (int i = 0; i < PLACES; i++)
        if (*names[i] && json_array_size(json_object_get(axes, names[i])) == 0) {
            *error = record_no_axis(axes, names[i]);
            return false;
        }
    for (int i = 0; i < PLACES; i++)
        take_axis(json_object_get(axes, names[i]), names[i], axes_of[i]);
    if (*p->ratio && d->ratio.count != 2) {
        *error = xasprintf("a ratio needs an axis of two values; %s has %zu", p->ratio, d->ratio.count);
        return false;
    }
    if (d->panels.count <= CHART_MAX_PANELS && d->lines.count <= CHART_MAX_LINES &&
        d->panels.count * d->lines.count * d->x.count <= CHART_MAX_CELLS)
        return true;
    *error =
        xasprintf("%zu panels of %zu lines with %zu values are too many: %d panels, %d lines are allowed",
                  d->panels.count, d->lines.count, d->x.count, CHART_MAX_PANELS, CHART_MAX_LINES);
    return false;
}

/* The first values of all axes of several values that the picture does not use. */
static json_t *fix_rest(const struct record_points *points, const struct picture *p, struct chart_data *d)
{
    json_t *fixed = json_object(), *values;
    const char *name;
    d->fixed = xstrdup("");
    json_object_foreach(json_object_get(points->header, "axes"), name, values)
    {
        if (json_array_size(values) < 2 || !strcmp(name, p->x) || !strcmp(name, p->lines) ||
            !strcmp(name, p->panels) || !strcmp(name, p->best) || !strcmp(name, p->ratio))
            continue;
        json_set(fixed, name, json_incref(json_array_get(values, 0)));
        char *label = chart_label(json_array_get(values, 0));
        words_append(&d->fixed, "%s%s %s", *d->fixed ? ", " : "", name, label);
        free(label);
    }
    if (*p->ratio)
        words_append(&d->fixed, "%s%s %s / %s", *d->fixed ? ", " : "", p->ratio, d->ratio.label[1],
                     d->ratio.label[0]);
    return fixed;
}

/* --- what the values are -------------------------------------------------------------------------------- */

/* The unit that a figure's name ends in, as people write it; NULL: it ends in none. */
static const char *unit_of(const char *ending)
{
    static const char *const UNITS[][2] = {{"_s", "s"},   {"_ms", "ms"}, {"_us", "us"},
                                           {"_ps", "ps"}, {"_pct", "%"}, {"_bytes", "bytes"}};
    for (size_t i = 0; i < sizeof UNITS / sizeof *UNITS; i++)
        if (strcmp(ending, UNITS[i][0]) == 0)
            return UNITS[i][1];
    return NULL;
}

/* "host idle, %" of host_idle_pct; malloc'd. As in page/web/study_section.js. */
static char *words_of_name(const char *figure)
{
    const char *last = strrchr(figure, '_'), *unit = last && last > figure ? unit_of(last) : NULL;
    char *words = unit ? xasprintf("%.*s, %s", (int)(last - figure), figure, unit) : xstrdup(figure);
    for (char *c = words; *c; c++)
        if (*c == '_')
            *c = ' ';
    return words;
}

/* What a figure is called where the picture does not say so; malloc'd. */
static char *words_for(const char *figure)
{
    static const char *const WORDS[][2] = {{"time_s", "time, s"},
                                           {"total_s", "total time, s"},
                                           {"virtual_time_s", "virtual time, s"},
                                           {"idle_pct", "idle, % of all nodes' time"},
                                           {"speedup", "speed-up"},
                                           {"speed_per_node", "speed-up / nodes"}};
    for (size_t i = 0; i < sizeof WORDS / sizeof *WORDS; i++)
        if (strcmp(figure, WORDS[i][0]) == 0)
            return xstrdup(WORDS[i][1]);
    return words_of_name(figure);
}

static double greatest(const double *values, size_t count)
{
    double most = 0;
    for (size_t i = 0; i < count; i++)
        most = fmax(most, fabs(values[i])); /* fmax passes over NAN */
    return most;
}

/* The figure's words without their unit. */
static int words_alone(const char *words)
{
    return (int)strcspn(words, ",");
}

/* What the values are called; malloc'd. A ratio has no unit. */
static char *label_of(const struct picture *p)
{
    char *words = *p->y_label ? xstrdup(p->y_label) : words_for(p->figure), *label;
    if (*p->y_label || (!*p->best && !*p->ratio))
        return words;
    label = *p->best ? xasprintf("%s with the least %.*s", p->best, words_alone(words), words)
                     : xasprintf("%.*s, ratio", words_alone(words), words);
    free(words);
    return label;
}

/* Labels the values. Seconds that are all below 0.1 become milliseconds, or microseconds. */
static void take_label(const struct picture *p, struct chart_data *d, size_t cells)
{
    char *words = label_of(p);
    size_t stem = strlen(words) > 3 ? strlen(words) - 1 : 0; /* without the s of ", s" */
    double most = greatest(d->drawn, cells);
    bool seconds = stem && strcmp(words + stem - 2, ", s") == 0 && !*p->best && !*p->ratio;
    d->y_label = words;
    if (!seconds || most >= 0.1 || !(most > 0))
        return;
    bool micro = most < 1e-3;
    d->y_label = xasprintf("%.*s%s", (int)stem, words, micro ? "us" : "ms");
    free(words);
    for (size_t i = 0; i < cells; i++)
        d->drawn[i] *= micro ? 1e6 : 1e3;
}

/* --- the whole ------------------------------------------------------------------------------------------ */

bool chart_data_take(const struct record_points *points, const struct picture *p, struct chart_data *d,
                     char **error)
{
    *d = (struct chart_data){0};
    if (!take_axes(points, p, d, error))
        return false;
    size_t cells = d->panels.count * d->lines.count * d->x.count;
    struct taker t = {p, d, xcalloc(cells, sizeof *t.least), fix_rest(points, p, d)};
    d->drawn = xcalloc(cells, sizeof *d->drawn);
    for (size_t i = 0; i < cells; i++)
        t.least[i] = d->drawn[i] = NAN;
    bool ok = points->each(points->arg, take_point, &t, error);
    for (size_t i = 0; *p->ratio && i < cells; i++)
        d->drawn[i] /= t.least[i];
    take_label(p, d, cells);
    json_decref(t.fixed);
    free(t.least);
    return ok;
}

static void free_axis(struct chart_axis *a)
{
    for (size_t i = 0; a->label && i < a->count; i++)
        free(a->label[i]);
    free(a->label);
    free(a->position);
    json_decref(a->index);
}

void chart_data_free(struct chart_data *d)
{
    free_axis(&d->x);
    free_axis(&d->lines);
    free_axis(&d->panels);
    free_axis(&d->best);
    free_axis(&d->ratio);
    free(d->drawn);
    free(d->y_label);
    free(d->fixed);
}

const char *chart_baseline(const json_t *header, const struct picture *p)
{
    const char *baseline = json_string_value(json_object_get(header, "baseline"));
    bool speed = strcmp(p->figure, "speedup") == 0 || strcmp(p->figure, "speed_per_node") == 0;
    return baseline && speed ? baseline : "";
}
