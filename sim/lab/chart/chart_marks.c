/* chart_marks.c - see chart_marks.h. */
#include "lab/chart/chart_marks.h"

#include <math.h>
#include <string.h>

bool marks_are_choices(const struct chart_data *d)
{
    return !d->x.numeric || *d->best.name;
}

/* --- side by side --------------------------------------------------------------------------------------- */

/* The least distance of two neighbouring values, as a part of the axis. */
static double least_gap(const struct chart_axis *axis, const struct scale *s)
{
    enum { ENOUGH = 1000 };
    double least = 1;
    for (size_t i = 1; i < axis->count && i < ENOUGH; i++)
        least = fmin(least, fabs(scale_part(s, axis->position[i]) - scale_part(s, axis->position[i - 1])));
    return least;
}

static void set_side_by_side(const struct chart_data *d, size_t x, const struct scale *s, struct mark marks[])
{
    double gap = least_gap(&d->x, s), at = scale_part(s, d->x.position[x]);
    double step = fmin(0.7 * gap / (double)d->lines.count, 0.022);
    for (size_t line = 0; line < d->lines.count; line++) {
        double beside = ((double)line - (double)(d->lines.count - 1) / 2) * step;
        marks[line] = (struct mark){scale_value(s, at + beside), 1, false};
    }
}

/* --- one in another ------------------------------------------------------------------------------------- */

/* Is the mark of another line so near that one covers the other? A marker is some 1/40 of a panel high. */
static bool covers(const struct chart_data *d, size_t panel, size_t x, const struct scale *s, size_t a,
                   size_t b)
{
    double apart = scale_part(s, chart_at(d, panel, a, x)) - scale_part(s, chart_at(d, panel, b, x));
    return fabs(apart) < 0.012;
}

/* Of lines that cover one another, the first has the largest marker. */
static void set_one_in_another(const struct chart_data *d, size_t panel, size_t x, const struct scale *s,
                               struct mark marks[])
{
    for (size_t line = 0; line < d->lines.count; line++) {
        size_t later = 0;
        for (size_t other = line + 1; other < d->lines.count; other++)
            later += covers(d, panel, x, s, line, other);
        marks[line] = (struct mark){d->x.position[x], 1 + 0.5 * fmin((double)later, 4), later > 0};
    }
}

void marks_of(const struct chart_data *d, size_t panel, size_t x, const struct scale *x_scale,
              const struct scale *y_scale, struct mark marks[])
{
    enum { MOST_MARKS = 40 };
    size_t every = (d->x.count + MOST_MARKS - 1) / MOST_MARKS;
    if (marks_are_choices(d)) {
        set_side_by_side(d, x, x_scale, marks);
        return;
    }
    set_one_in_another(d, panel, x, y_scale, marks);
    for (size_t line = 0; line < d->lines.count; line++)
        if ((x + line) % every)
            marks[line].size = NAN;
}

/* --- lines that are equal ------------------------------------------------------------------------------- */

static bool are_same(const struct chart_data *d, size_t a, size_t b)
{
    bool any = false;
    for (size_t panel = 0; panel < d->panels.count; panel++)
        for (size_t x = 0; x < d->x.count; x++) {
            double u = chart_at(d, panel, a, x), v = chart_at(d, panel, b, x);
            if (isnan(u) && isnan(v))
                continue;
            if (!(fabs(u - v) <= 1e-9 * fabs(u)))
                return false;
            any = true;
        }
    return any;
}

size_t marks_same_line(const struct chart_data *d, size_t line)
{
    for (size_t other = 0; other < line; other++)
        if (are_same(d, other, line))
            return other;
    return line;
}
