/* chart_marks.h - the places of the markers of a picture's points, such that no marker hides another. */
#ifndef LAB_CHART_CHART_MARKS_H
#define LAB_CHART_CHART_MARKS_H
#include "lab/chart/chart_scale.h"

struct mark {
    double x;
    double size; /* 1: a single marker's; NAN: this point has none */
    bool hollow;
};

/* Are the values choices, so that nothing lies between two of them? Then no lines join the points. */
bool marks_are_choices(const struct chart_data *d);

/* Marks of all lines at value x of the panel; marks[] has room for d->lines.count. Markers of choices stand
 * side by side. Other markers that would cover one another get different sizes, the larger ones hollow. */
void marks_of(const struct chart_data *d, size_t panel, size_t x, const struct scale *x_scale,
              const struct scale *y_scale, struct mark marks[]);

/* The first line that has the same values as this one everywhere; the line itself if there is none. */
size_t marks_same_line(const struct chart_data *d, size_t line);
#endif
