/* chart_layout.h - the places of a picture's parts: heading, panels in rows and columns, legend at their
 * right. In pixels of the SVG, from the top left corner. */
#ifndef LAB_CHART_CHART_LAYOUT_H
#define LAB_CHART_CHART_LAYOUT_H
#include <stdbool.h>
#include <stddef.h>

struct box {
    unsigned left, top, width, height;
};

/* What the parts need. */
struct layout_needs {
    size_t panels;
    bool panel_titles, notes;
    unsigned y_labels, x_labels; /* the room that the axes' tic labels take beside a panel, and below it */
    size_t entries;              /* of the legend; 0: there is no legend */
    unsigned entry_width;        /* of its longest text */
    unsigned heading_width, heading_lines;
};

struct layout {
    struct layout_needs needs;
    unsigned width, height;
    unsigned columns;
    struct box first;     /* the first panel's frame */
    unsigned right, down; /* from a panel's corner to that of the next column and row */
    struct box legend;
    unsigned legend_rows; /* entries in a column of the legend */
};

/* The width of a panel that is one of so many. */
unsigned layout_panel_width(size_t panels);

struct layout layout_of(const struct layout_needs *needs);
/* How far from the top the notes are. */
unsigned layout_notes_top(const struct layout *l);
/* The frame of a panel. */
struct box layout_panel(const struct layout *l, size_t panel);
/* Is the panel the first of its row; is there none below it? */
bool layout_is_left(const struct layout *l, size_t panel);
bool layout_is_lowest(const struct layout *l, size_t panel);
#endif
