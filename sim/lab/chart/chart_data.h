/* chart_data.h - the values that a picture draws: chart_data.c takes them from results, chart_script.c and
 * findings.c show them. */
#ifndef LAB_CHART_CHART_DATA_H
#define LAB_CHART_CHART_DATA_H
#include "lab/chart/chart.h"

#include <stddef.h>

/* An axis of a picture with its values in order. An axis that the picture does not use has the name "" and
 * one value. */
struct chart_axis {
    const char *name;
    size_t count;
    char **label;     /* of each value */
    double *position; /* where each value is drawn: numbers at themselves, texts at 1, 2, 3 ... */
    json_t *index;    /* label: the value's index */
    bool numeric;
};

struct chart_data {
    struct chart_axis x, lines, panels, best, ratio;
    double *drawn; /* for each panel, line and x; NAN where there is no point */
    char *y_label; /* what the values are: "time, s"; short times are in ms or us, and the label says so */
    char *fixed; /* "disks 2, clock 40": the axes held at their first values; "host b / a": a ratio; or "" */
};

enum { CHART_MAX_PANELS = 64, CHART_MAX_LINES = 64, CHART_MAX_CELLS = 10000000 };

bool chart_data_take(const struct record_points *points, const struct picture *p, struct chart_data *d,
                     char **error);
void chart_data_free(struct chart_data *d);

/* The baseline of the picture's speeds, as the header of the results has it; "" if the picture has none. */
const char *chart_baseline(const json_t *header, const struct picture *p);

/* An axis's value as text, malloc'd. */
char *chart_label(const json_t *value);

static inline double chart_at(const struct chart_data *d, size_t panel, size_t line, size_t x)
{
    return d->drawn[(panel * d->lines.count + line) * d->x.count + x];
}
#endif
