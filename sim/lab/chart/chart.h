/* chart.h - draws pictures of a study's results by gnuplot. */
#ifndef LAB_CHART_CHART_H
#define LAB_CHART_CHART_H
#include "lab/chart/picture.h"
#include "lab/chart/record.h"

/* Is there a gnuplot that runs? False with *error malloc'd, which says what to install. */
bool chart_can_draw(char **error);

/* Draws DIR/FILE.png and DIR/FILE.svg. Points that failed or lack the figure are left out. An axis of several
 * values that the picture does not use is held at its first value; the picture says so. False with *error
 * malloc'd. */
bool chart_draw(const struct record_points *points, const struct picture *picture, const char *dir,
                char **error);

/* The pictures of a study that names none: time, idle time, speed-up and speed per node against nodes, or
 * time and idle time against the first axis of numbers, or of names if there is none. Each value of the next
 * axis is a line, each value of the axis after that a panel. Fills list and returns how many; the texts
 * belong to points. */
enum { CHART_STANDARD = 4 };
size_t chart_standard(const struct record_points *points, struct picture list[CHART_STANDARD]);
#endif
