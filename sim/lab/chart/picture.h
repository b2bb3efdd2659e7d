/* picture.h - what a picture of a study shows: a figure against an axis, or the value of axis `best` at which
 * the figure is least. A text that is not given is "". The texts belong to whoever made the picture. */
#ifndef LAB_CHART_PICTURE_H
#define LAB_CHART_PICTURE_H
#include <stdbool.h>

struct picture {
    const char *file; /* FILE.png and FILE.svg */
    const char *title, *x_label, *y_label;
    const char *figure;             /* its key in the results */
    const char *x, *lines, *panels; /* names of axes */
    const char *best;               /* draw this axis's value where figure is least */
    bool log_x, log_y;              /* logarithmic axes, if the values allow it */
    bool own_ranges;                /* each panel has a range of y of its own; otherwise all have the same */
};
#endif
