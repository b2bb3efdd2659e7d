/* show_gantt.c - the Gantt chart: what each node, or class of nodes, does over time. */
#include "kernel/xalloc.h"
#include <stdlib.h>
#include "lab/show/display_parts.h"
#include "lab/show/stacked.h"

static double row_height(const struct show *s)
{
    return show_row_height(s->rows.count, 480, 5, 34);
}

/* Where rows are low, those of hosts are higher: for what hosts do, all others wait. The rows are a copy of
 * the show's; only their edges, which the caller frees, are its own. */
static double rows_height(const struct show *s, struct node_rows *rows)
{
    const double low = 12, times = 4;
    *rows = s->rows;
    double height = row_height(s);
    return height * (height < low ? node_rows_heighten(rows, s->trace, times) : rows->count);
}

double gantt_height(const struct show *s)
{
    struct node_rows rows;
    double height = rows_height(s, &rows);
    free(rows.edge);
    return HEAD_HEIGHT + height + 76;
}

static char *notes(const struct show *s, bool higher)
{
    if (s->rows.per == 1)
        return xasprintf("A row a node%s; pieces shorter than a pixel share its height, each by its length",
                         higher ? ", those that serve the others higher" : "");
    char *rows = node_rows_text(&s->rows, "rows"),
         *all = xasprintf("%s; each activity has its share of the row's height", rows);
    free(rows);
    return all;
}

void gantt_draw(const struct show *s, const struct canvas *c)
{
    double h = row_height(s), gap = h > 12 ? 3 : h > 9 ? 1 : 0.5;
    struct node_rows rows;
    struct plot p = {LEFT, HEAD_HEIGHT, CANVAS_WIDTH - LEFT - 24, rows_height(s, &rows)};
    struct state_times times = stacked_times(s->trace, &s->rows, p.w);
    struct canvas field = stacked_canvas(c, p, &times);
    show_head(s, c, "Gantt chart", notes(s, rows.edge));
    for (int32_t row = 0; row < s->rows.count; row++) {
        double top = p.h * node_rows_edge(&rows, row), bottom = p.h * node_rows_edge(&rows, row + 1);
        struct plot area = {p.x, p.y + top + gap / 2, p.w, bottom - top - gap};
        stacked_draw(&field, area, &times, row, s->rows.classes[row].size, ACTIVITIES);
    }
    stacked_finish(c, p, &field);
    canvas_frame(c, p);
    axes_rows(c, p, &rows, s->trace, "node");
    axes_time(c, p, s->trace->from, s->trace->to);
    stacked_legend(c, p.x, p.y + p.h + 60, s->trace, &times, s->rows.nodes, ACTIVITIES);
    state_times_free(&times);
    free(rows.edge);
}
