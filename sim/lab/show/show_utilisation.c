/* show_utilisation.c - the utilisation count: how many nodes are in each activity, over time. */
#include "kernel/xalloc.h"
#include "lab/show/display_parts.h"
#include "lab/show/stacked.h"

enum { PLOT_HEIGHT = 400 };

double utilisation_height(const struct show *s)
{
    (void)s;
    return HEAD_HEIGHT + PLOT_HEIGHT + 76;
}

void utilisation_draw(const struct show *s, const struct canvas *c)
{
    struct plot p = {LEFT, HEAD_HEIGHT, CANVAS_WIDTH - LEFT - 24, PLOT_HEIGHT};
    struct state_times rows = stacked_times(s->trace, &s->rows, p.w), all = state_times_total(&rows);
    show_head(s, c, "Utilisation count",
              xstrdup("How many nodes do what; pieces shorter than a pixel share it, each by its length"));
    struct canvas field = stacked_canvas(c, p, &all);
    stacked_draw(&field, p, &all, 0, s->rows.nodes, ACTIVITIES);
    stacked_finish(c, p, &field);
    canvas_frame(c, p);
    axes_number(c, p, s->rows.nodes, false, s->rows.host ? "nodes (with the host)" : "nodes");
    axes_time(c, p, s->trace->from, s->trace->to);
    stacked_legend(c, p.x, p.y + p.h + 60, s->trace, &all, s->rows.nodes, ACTIVITIES);
    state_times_free(&all);
    state_times_free(&rows);
}
