/* stacked.c - see stacked.h. */
#include "lab/show/stacked.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

static const double SEEN = 0.0005; /* if less of the time has no program, the legend does not say so */
enum { MOST_CORNERS = 45000 };     /* in an SVG: of about 35 bytes */

/* How many corners the areas have together: how often the sum of the first activities changes, by what is
 * seen, from a column to the next. */
static size_t corners(const struct state_times *s)
{
    size_t count = 0;
    double seen = 0.04 * (double)(s->bins.to - s->bins.from) / s->bins.count;
    for (int32_t row = 0; row < s->rows; row++)
        for (uint32_t bin = 1; bin < s->bins.count; bin++) {
            const double *now = state_times_at(s, row, bin), *before = state_times_at(s, row, bin - 1);
            double change = 0;
            for (int a = 0; a < ACTIVITIES; a++)
                count += fabs(change += now[a] - before[a]) > seen;
        }
    return count;
}

struct state_times stacked_times(const struct trace *t, const struct node_rows *r, double width)
{
    return state_times_make(t, r, time_bins_make(t->from, t->to, (uint32_t)width * CANVAS_PIXELS));
}

struct canvas stacked_canvas(const struct canvas *c, struct plot p, const struct state_times *s)
{
    if (!c->vector || corners(s) <= MOST_CORNERS)
        return *c;
    cairo_surface_t *pixels = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, (int)ceil(p.w) * CANVAS_PIXELS,
                                                         (int)ceil(p.h) * CANVAS_PIXELS);
    struct canvas field = {cairo_create(pixels), false, p.w, p.h};
    cairo_surface_destroy(pixels); /* field.cr holds it */
    cairo_scale(field.cr, CANVAS_PIXELS, CANVAS_PIXELS);
    cairo_translate(field.cr, -p.x, -p.y);
    return field;
}

void stacked_finish(const struct canvas *c, struct plot p, struct canvas *field)
{
    if (field->cr == c->cr)
        return;
    cairo_save(c->cr);
    cairo_translate(c->cr, p.x, p.y);
    cairo_scale(c->cr, 1.0 / CANVAS_PIXELS, 1.0 / CANVAS_PIXELS);
    cairo_set_source_surface(c->cr, cairo_get_target(field->cr), 0, 0);
    cairo_paint(c->cr);
    cairo_restore(c->cr);
    cairo_destroy(field->cr);
}

/* The height of the first `activities` of a bin, of 1 for each node. */
static double height(const struct state_times *s, int32_t row, uint32_t bin, enum activity activities)
{
    const double *at = state_times_at(s, row, bin);
    double sum = 0, width = time_bins_width(&s->bins, bin);
    for (int a = 0; a < (int)activities; a++)
        sum += at[a];
    return width > 0 ? sum / width : 0;
}

/* The area under the sum of the first `activities`: steps, a bin each, those of one height together. */
static void draw_under(const struct canvas *c, struct plot p, const struct state_times *s, int32_t row,
                       double nodes, enum activity activities)
{
    double bottom = p.y + p.h, column = p.w / s->bins.count, before = bottom;
    bool any = false;
    cairo_move_to(c->cr, p.x, bottom);
    for (uint32_t bin = 0; bin < s->bins.count; bin++) {
        double y = bottom - canvas_round(c, fmin(height(s, row, bin, activities) / nodes, 1) * p.h);
        if (fabs(y - before) > 1e-9) {
            double x = canvas_round(c, p.x + bin * column);
            cairo_line_to(c->cr, x, before);
            cairo_line_to(c->cr, x, y);
            any = true;
        }
        before = y;
    }
    if (any) {
        cairo_line_to(c->cr, p.x + p.w, before);
        cairo_line_to(c->cr, p.x + p.w, bottom);
        cairo_close_path(c->cr);
        canvas_colour(c, palette_activity(activities - 1));
        cairo_fill(c->cr);
    }
    cairo_new_path(c->cr);
}

void stacked_draw(const struct canvas *c, struct plot area, const struct state_times *s, int32_t row,
                  double nodes, enum activity activities)
{
    for (enum activity a = activities; a > 0; a--)
        draw_under(c, area, s, row, nodes, a);
}

struct share_text stacked_share(double share)
{
    struct share_text t;
    if (share > 0 && share < 0.0005)
        snprintf(t.text, sizeof t.text, "< 0.1 %%");
    else
        snprintf(t.text, sizeof t.text, "%.1f %%", 100 * share);
    return t;
}

const char *stacked_whole(const struct trace *t)
{
    return t->topo.host ? "Of all time: " : "Of all nodes' time: ";
}

void stacked_legend(const struct canvas *c, double x, double y, const struct trace *t,
                    const struct state_times *s, double nodes, enum activity activities)
{
    const struct text_style style = {10, GREY, ANCHOR_LEFT, false};
    const char *of = stacked_whole(t);
    struct legend_entry list[ACTIVITIES + 1];
    size_t count = 0;
    double all = nodes * (double)(vt_min(s->bins.to, t->end) - s->bins.from);
    double sums[ACTIVITIES + 1] = {[ACTIVITIES] = all};
    for (size_t i = 0; i < (size_t)s->rows * s->bins.count * ACTIVITIES; i++)
        sums[i % ACTIVITIES] += s->sums[i], sums[ACTIVITIES] -= s->sums[i];
    for (enum activity a = 0; a <= ACTIVITIES; a++) {
        if ((a >= activities && a < ACTIVITIES) || (a == ACTIVITIES && sums[a] <= SEEN * all))
            continue;
        list[count++] = (struct legend_entry){
            palette_activity(a), xasprintf("%s %s", activity_name(t, a), stacked_share(sums[a] / all).text),
            false};
    }
    if (count > ACTIVITIES)
        x = HEAD_LEFT; /* all of them are too long for the plot's width */
    canvas_text(c, x, y, style, of);
    legend(c, x + canvas_text_width(c, style, of) + 6, y, list, count);
}
