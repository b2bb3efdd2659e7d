/* picture.h - what a picture of a study shows: a figure against an axis, the value of axis `best` at which
 * the figure is least, or the ratio of two figures. A text that is not given is "". The texts belong to
 * whoever made the picture. */
#ifndef LAB_CHART_PICTURE_H
#define LAB_CHART_PICTURE_H
#include <stdbool.h>

struct picture {
    const char *file; /* FILE.png and FILE.svg */
    const char *title, *x_label, *y_label, *lines_label, *panels_label;
    const char *figure;             /* its key in the results */
    const char *x, *lines, *panels; /* names of axes */
    const char *best;               /* draw this axis's value where figure is least */
    const char *ratio;              /* draw figure at this axis's second value divided by that at its first */
    bool log_x, log_y;              /* logarithmic axes, if the values allow it */
    bool own_ranges;                /* each panel has a range of y of its own; otherwise all have the same */
};

/* The texts of a picture of which nothing is given: an initializer. */
#define PICTURE_NO_TEXTS                                                                                     \
    .file = "", .title = "", .x_label = "", .y_label = "", .lines_label = "", .panels_label = "",            \
    .figure = "", .x = "", .lines = "", .panels = "", .best = "", .ratio = ""
#endif
