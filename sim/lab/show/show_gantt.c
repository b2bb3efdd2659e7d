/* show_gantt.c - the Gantt chart: what each node, or class of nodes, does over time. */
#include "kernel/xalloc.h"
#include <stdlib.h>
#include "lab/show/display_parts.h"
#include "lab/show/stacked.h"

static double row_height(const struct show *s)
{
    return show_row_height(s->rows.count, 480, 5, 34);
}

double gantt_height(const struct show *s)
{
    return HEAD_HEIGHT + s->rows.count * row_height(s) + 76;
}

static char *notes(const struct show *s)
{
    if (s->rows.per == 1)
        return xstrdup("A row a node; what is shorter than a pixel has its share of the pixel's height");
    char *rows = node_rows_text(&s->rows, "rows"),
         *all = xasprintf("%s; each activity has its share of the row's height", rows);
    free(rows);
    return all;
}

void gantt_draw(const struct show *s, const struct canvas *c)
{
    double h = row_height(s), gap = h > 12 ? 3 : h > 9 ? 1 : 0.5;
    struct plot p = {LEFT, HEAD_HEIGHT, CANVAS_WIDTH - LEFT - 24, s->rows.count * h};
    struct state_times times = stacked_times(s->trace, &s->rows, p.w);
    struct canvas field = stacked_canvas(c, p, &times);
    show_head(s, c, "Gantt chart", notes(s));
    for (int32_t row = 0; row < s->rows.count; row++) {
        struct plot area = {p.x, p.y + row * h + gap / 2, p.w, h - gap};
        stacked_draw(&field, area, &times, row, s->rows.classes[row].size, ACTIVITIES);
    }
    stacked_finish(c, p, &field);
    canvas_frame(c, p);
    axes_rows(c, p, &s->rows, s->trace, "node");
    axes_time(c, p, s->trace->from, s->trace->to);
    stacked_legend(c, p.x, p.y + p.h + 60, &times, s->rows.nodes, ACTIVITIES);
    state_times_free(&times);
}
