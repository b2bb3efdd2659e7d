/* chart.h - a study's pictures, as gnuplot scripts, from its results alone. */
#ifndef LAB_CHART_CHART_H
#define LAB_CHART_CHART_H
#include "lab/chart/picture.h"
#include "lab/chart/record.h"

/* Draws DIR/FILE.png and .svg by gnuplot. Points that failed or lack the figure are left out; axes of several values that
 * have no place in the picture stand at their first, and the picture says so. False with *error malloc'd. */
bool chart_draw(const struct record_points *points, const struct picture *picture, const char *dir,
                char **error);

/* The pictures of a study that names none, against nodes or its first axis of numbers: time, speed-up, speed per node,
 * idle time; one line for each value of the next axis, one panel for each of the one after. Into list, at most
 * CHART_STANDARD; the number. Texts belong to points. */
enum { CHART_STANDARD = 4 };
size_t chart_standard(const struct record_points *points, struct picture list[CHART_STANDARD]);
#endif
