/* picture.h - what a picture of a study shows: a figure against an axis, or the value of an axis at which the figure is
 * least. Texts are "" where nothing is given, and belong to whoever made it. */
#ifndef LAB_CHART_PICTURE_H
#define LAB_CHART_PICTURE_H
#include <stdbool.h>

struct picture {
    const char *file; /* FILE.png and FILE.svg */
    const char *title, *x_label, *y_label;
    const char *figure;             /* its key in the results */
    const char *x, *lines, *panels; /* names of axes */
    const char *best;               /* draw this axis's value where figure is least */
    bool log_x, log_y;              /* where its values allow it */
};
#endif
