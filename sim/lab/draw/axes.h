/* axes.h - axes with their units, titles and legends. */
#ifndef LAB_DRAW_AXES_H
#define LAB_DRAW_AXES_H
#include <stddef.h>
#include "lab/draw/canvas.h"
#include "lab/draw/node_rows.h"

/* The step between ticks so that at most `most` of them divide the range: 1, 2 or 5 times a power of ten. */
double axis_step(double range, int most);
/* The step for things that are counted, such as nodes: 1 or more, unless the range is less than one. */
double axis_count_step(double range, int most);
/* A round number, most or more: at which a scale may end. 1 if most is 0. */
double axis_end(double most);
/* A time for people, of which differences of `resolution` show: "1.25 ms", "0". malloc'd. */
char *axis_time_text(vtime t, vtime resolution);
/* A number for people: "950", "1.2 k", "3 M"; of bytes: "1.5 kB". malloc'd. */
char *axis_number_text(double value, bool bytes);

/* A share, 0 to 1, in percent: "27.8 %", "0.04 %", "< 0.001 %". malloc'd. */
char *axis_percent_text(double share);

/* The axis of time below the plot, in s, ms, us, ns or ps; far from 0, as time after a round one. */
void axes_time(const struct canvas *c, struct plot p, vtime from, vtime to);
/* The axis of a count from 0 to most, left of the plot, with lines across it. */
void axes_number(const struct canvas *c, struct plot p, double most, bool bytes, const char *title);
/* The rows' labels, as many as there is room for, left of the plot. */
void axes_rows(const struct canvas *c, struct plot p, const struct node_rows *r, const struct trace *t,
               const char *title);
/* The same below the plot, for columns. */
void axes_columns(const struct canvas *c, struct plot p, const struct node_rows *r, const struct trace *t,
                  const char *title);

struct legend_entry {
    struct colour colour;
    char *text; /* malloc'd; freed by legend() */
    bool line;  /* a line instead of a square */
};
void legend(const struct canvas *c, double x, double y, struct legend_entry *list, size_t count);
#endif
