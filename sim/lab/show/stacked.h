/* stacked.h - activities over time, stacked: at each moment the share of the nodes in each. A row of one
 * node is in one activity at a time, so that the stack is a bar of one colour. What is shorter than a
 * column of the picture has its share of the column, exactly. */
#ifndef LAB_SHOW_STACKED_H
#define LAB_SHOW_STACKED_H
#include "lab/draw/axes.h"
#include "lab/draw/picture_head.h"
#include "lab/draw/palette.h"

/* The times of rows in as many bins as the picture has columns of pixels. */
struct state_times stacked_times(const struct trace *t, const struct node_rows *r, double width);

/* Where to draw all rows of s, which lie in the plot: on c itself; or, if an SVG would become large, on
 * pixels, which stacked_finish() then puts into the SVG as one image. */
struct canvas stacked_canvas(const struct canvas *c, struct plot p, const struct state_times *s);
void stacked_finish(const struct canvas *c, struct plot p, struct canvas *field);
/* Draws the first `activities` of a row into the area, whose height stands for `nodes` nodes. */
void stacked_draw(const struct canvas *c, struct plot area, const struct state_times *s, int32_t row,
                  double nodes, enum activity activities);
/* "7.3 %"; "< 0.1 %" of what is little, and not nothing. */
struct share_text {
    char text[16];
};
struct share_text stacked_share(double share);
/* What the shares of a legend are of; the host is no node. */
const char *stacked_whole(const struct trace *t);
/* The legend of the first `activities`, with the share of each in all time up to the end of the run, even if
 * that is 0: pictures of one run have one legend. */
void stacked_legend(const struct canvas *c, double x, double y, const struct trace *t,
                    const struct state_times *s, double nodes, enum activity activities);
#endif
