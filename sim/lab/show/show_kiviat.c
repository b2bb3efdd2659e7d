/* show_kiviat.c - Kiviat's diagram: a spoke a node, along which the shares of its time are set off. */
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/show/display_parts.h"
#include "lab/show/stacked.h"

enum { RADIUS = 230, MOST_CORNERS = 32 };
/* Shown are the activities before ACTIVITY_WAITING. */

struct kiviat {
    const struct show *show;
    struct state_times times; /* of the spokes */
    double rim;               /* the share of time that the rim stands for */
};

double kiviat_height(const struct show *s)
{
    (void)s;
    return HEAD_HEIGHT + 2 * RADIUS + 100;
}

struct point {
    double x, y;
};

/* The point of a spoke at a share of the radius; the first spoke points up, the next follow clockwise. */
static struct point at(struct point centre, double spoke, int32_t spokes, double share)
{
    double angle = 2 * M_PI * spoke / spokes - M_PI / 2;
    return (struct point){centre.x + cos(angle) * share * RADIUS, centre.y + sin(angle) * share * RADIUS};
}

/* The path through the shares of all spokes: corners at the spokes; of few or many spokes an arc each. */
static void trace_path(const struct canvas *c, struct point centre, const double *shares, int32_t spokes)
{
    cairo_new_path(c->cr);
    for (int32_t i = 0; i < spokes; i++) {
        if (spokes >= 3 && spokes <= MOST_CORNERS) {
            struct point p = at(centre, i, spokes, shares[i]);
            cairo_line_to(c->cr, p.x, p.y);
            continue;
        }
        double middle = 2 * M_PI * i / spokes - M_PI / 2;
        cairo_arc(c->cr, centre.x, centre.y, shares[i] * RADIUS, middle - M_PI / spokes,
                  middle + M_PI / spokes);
    }
    cairo_close_path(c->cr);
}

static void draw_rings(const struct canvas *c, struct point centre, double rim)
{
    for (int quarter = 1; quarter <= 4; quarter++) {
        char *text = xasprintf("%g %%", 25 * quarter * rim);
        cairo_new_path(c->cr);
        cairo_arc(c->cr, centre.x, centre.y, RADIUS * quarter / 4.0, 0, 2 * M_PI);
        canvas_colour(c, quarter == 4 ? INK : GREY);
        cairo_set_line_width(c->cr, quarter == 4 ? 1 : 0.5);
        cairo_stroke(c->cr);
        canvas_text_clear(c, centre.x + 10, centre.y - RADIUS * quarter / 4.0 + 11,
                          (struct text_style){9, INK, ANCHOR_LEFT, false}, text);
        free(text);
    }
}

static void draw_spokes(const struct canvas *c, struct point centre, const struct show *s)
{
    int32_t step = 1, spokes = s->rows.count;
    while (spokes / step > 32)
        step *= 2;
    for (int32_t i = 0; i < spokes; i++) {
        bool host = s->rows.host && i == spokes - 1;
        struct point rim = at(centre, i, spokes, 1), beyond = at(centre, i, spokes, 1.05);
        if (step == 1)
            canvas_line(c, centre.x, centre.y, rim.x, rim.y, 0.4, GREY);
        if (!host && i % step)
            continue;
        char *text = node_rows_label(&s->rows, s->trace, i);
        double right = cos(2 * M_PI * i / spokes - M_PI / 2);
        canvas_text(c, beyond.x, beyond.y + 3.5,
                    (struct text_style){10, INK,
                                        right > 0.2    ? ANCHOR_LEFT
                                        : right < -0.2 ? ANCHOR_RIGHT
                                                       : ANCHOR_MIDDLE,
                                        false},
                    text);
        free(text);
    }
}

/* The share of the first `activities` of a row's time. */
static double share(const struct state_times *t, int32_t row, double nodes, int activities)
{
    double sum = 0;
    for (int a = 0; a < activities; a++)
        sum += state_times_at(t, row, 0)[a];
    return sum / (nodes * (double)(t->bins.to - t->bins.from));
}

static char *notes(const struct show *s, const struct state_times *single)
{
    double least = INFINITY, most = 0, sum = 0;
    for (int32_t n = 0; n < single->rows; n++) {
        double v = share(single, n, 1, ACTIVITY_HANDLER + 1);
        least = fmin(least, v), most = fmax(most, v), sum += v;
    }
    char *rows = s->rows.per > 1 ? node_rows_text(&s->rows, "spokes") : xstrdup("a spoke a node");
    char *text = xasprintf(
        "%s; computing: %s of the time at the least busy node, %s on average, %s at the busiest", rows,
        stacked_share(least).text, stacked_share(sum / single->rows).text, stacked_share(most).text);
    free(rows);
    return text;
}

/* The rim is all of the time; or less, if no spoke comes near. */
static double rim_of(const struct show *s, const struct state_times *times)
{
    static const double RIMS[] = {0.01, 0.02, 0.04, 0.1, 0.2, 0.4, 1};
    double most = 0;
    size_t i = 0;
    for (int32_t row = 0; row < times->rows; row++)
        most = fmax(most, share(times, row, s->rows.classes[row].size, ACTIVITY_WAITING));
    while (RIMS[i] < 1 && RIMS[i] < most)
        i++;
    return RIMS[i];
}

/* The areas within the shares, the sum of all activities first. */
static void draw_areas(const struct kiviat *k, const struct canvas *c, struct point centre)
{
    const struct node_rows *rows = &k->show->rows;
    double *shares = xcalloc((size_t)rows->count, sizeof *shares);
    for (int a = ACTIVITY_WAITING; a > 0; a--) {
        for (int32_t i = 0; i < rows->count; i++)
            shares[i] = fmin(share(&k->times, i, rows->classes[i].size, a) / k->rim, 1);
        trace_path(c, centre, shares, rows->count);
        canvas_colour(c, palette_activity((enum activity)(a - 1)));
        cairo_fill(c->cr);
    }
    free(shares);
}

void kiviat_draw(const struct show *s, const struct canvas *c)
{
    struct time_bins whole = {s->trace->from, s->trace->to, 1};
    struct node_rows single = node_rows_single(s->trace);
    struct state_times each = state_times_make(s->trace, &single, whole);
    struct kiviat k = {s, state_times_make(s->trace, &s->rows, whole), 1};
    struct point centre = {CANVAS_WIDTH / 2.0, HEAD_HEIGHT + RADIUS + 24};
    k.rim = rim_of(s, &k.times);
    show_head(s, c, "Kiviat diagram: how busy each node was", notes(s, &each));
    draw_areas(&k, c, centre);
    draw_rings(c, centre, k.rim);
    draw_spokes(c, centre, s);
    stacked_legend(c, LEFT, centre.y + RADIUS + 58, s->trace, &k.times, s->rows.nodes, ACTIVITY_WAITING);
    state_times_free(&each);
    state_times_free(&k.times);
    node_rows_free(&single);
}
