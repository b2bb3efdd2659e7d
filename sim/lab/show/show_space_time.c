/* show_space_time.c - the space-time diagram: nodes' lines, and the messages between them. */
#include <math.h>
#include <stdlib.h>
#include "files/number.h"
#include "kernel/xalloc.h"
#include "lab/show/display_parts.h"
#include "lab/show/message_sample.h"
#include "lab/show/stacked.h"

enum { SCREENFUL = 400, MOST_ARROWS = 1000, MOST_UNASKED = 10000 };

/* What the message's end at its receiver was. */
enum end { AWAITED, EARLY, OTHERWISE, ENDS };
static const struct {
    uint32_t colour;
    const char *text;
} END_LOOKS[ENDS] = {[AWAITED] = {0x222222, "message that its receiver waited for"},
                     [EARLY] = {0xd97706, "message that waited for its receiver"},
                     [OTHERWISE] = {0xbbbbbb, "taken by a handler, or not in this interval"}};

struct space_time {
    const struct show *show;
    struct node_rows lines; /* a line a node */
    struct plot plot;
    double apart; /* of lines */
    struct message_sample sample;
};

static double lines_apart(int32_t lines)
{
    return show_row_height(lines, 500, 1, 60);
}

double space_time_height(const struct show *s)
{
    return HEAD_HEIGHT + s->rows.nodes * lines_apart(s->rows.nodes) + 96;
}

static enum end end_of(const struct trace *t, const struct trace_message *m)
{
    if (m->taking == TRACE_NONE)
        return OTHERWISE;
    return t->calls[m->taking].begin <= m->complete ? AWAITED : EARLY;
}

static double y_of(const struct space_time *d, int32_t node)
{
    return d->plot.y + (d->lines.row[node] + 0.5) * d->apart;
}

static double x_of(const struct space_time *d, vtime t)
{
    const struct trace *r = d->show->trace;
    return d->plot.x + ((double)t - (double)r->from) / (double)(r->to - r->from) * d->plot.w;
}

/* Is there room for activities on the lines? */
static bool has_bands(const struct space_time *d)
{
    return d->apart * 0.4 >= 2;
}

/* The nodes' lines; activities on them, where there is room. */
static void draw_lines(const struct canvas *c, const struct space_time *d)
{
    const struct trace *t = d->show->trace;
    double band = fmin(d->apart * 0.4, 9);
    for (int32_t n = 0; d->apart >= 4 && n < t->node_count; n++)
        if (d->lines.row[n] != TRACE_NONE)
            canvas_line(c, d->plot.x, y_of(d, n), x_of(d, vt_min(t->nodes[n].end, t->to)), y_of(d, n), 0.5,
                        GREY);
    if (!has_bands(d))
        return;
    struct state_times times = stacked_times(t, &d->lines, d->plot.w);
    struct canvas field = stacked_canvas(c, d->plot, &times);
    for (int32_t i = 0; i < d->lines.count; i++) {
        struct plot area = {d->plot.x, d->plot.y + (i + 0.5) * d->apart - band / 2, d->plot.w, band};
        stacked_draw(&field, area, &times, i, 1, ACTIVITY_WAITING);
    }
    stacked_finish(c, d->plot, &field);
    stacked_legend(c, d->plot.x, d->plot.y + d->plot.h + 60, t, &times, d->lines.nodes, ACTIVITY_WAITING);
    state_times_free(&times);
}

/* A message's line, from x1 to x2 >= x1. */
struct line {
    double x1, y1, x2, y2;
};

/* The part of a message's line that is in the plot, or so many points left or right of it: libcairo's
 * coordinates would overflow if a message were drawn that takes far longer than the plot's time. */
static struct line line_of(const struct space_time *d, const struct trace_message *m, double beyond)
{
    struct line l = {x_of(d, m->sent), y_of(d, m->from), x_of(d, m->complete), y_of(d, m->to)};
    double left = d->plot.x - beyond, right = d->plot.x + d->plot.w + beyond,
           slope = (l.y2 - l.y1) / (l.x2 - l.x1);
    if (l.x1 < left)
        l.y1 += slope * (left - l.x1), l.x1 = left;
    if (l.x2 > right)
        l.y2 += slope * (right - l.x2), l.x2 = right;
    return l;
}

static void arrow_head(const struct canvas *c, struct line l)
{
    double angle = atan2(l.y2 - l.y1, l.x2 - l.x1), size = fmin(6, hypot(l.x2 - l.x1, l.y2 - l.y1) / 2);
    for (int side = -1; side <= 1; side += 2) {
        cairo_move_to(c->cr, l.x2, l.y2);
        cairo_line_to(c->cr, l.x2 - size * cos(angle + side * 0.4), l.y2 - size * sin(angle + side * 0.4));
    }
}

/* Draws the sampled messages of one kind of end; returns whether there are any. */
static bool draw_messages(const struct canvas *c, const struct space_time *d, enum end end)
{
    bool any = false;
    for (size_t i = 0; i < d->sample.count; i++) {
        const struct trace_message *m = &d->show->trace->messages[d->sample.list[i]];
        if (end_of(d->show->trace, m) != end)
            continue;
        struct line l = line_of(d, m, d->plot.w);
        cairo_move_to(c->cr, canvas_round(c, l.x1), canvas_round(c, l.y1));
        cairo_line_to(c->cr, canvas_round(c, l.x2), canvas_round(c, l.y2));
        if (d->sample.count <= MOST_ARROWS)
            arrow_head(c, l);
        any = true;
    }
    canvas_colour(c, COLOUR(END_LOOKS[end].colour));
    cairo_set_line_width(c->cr, d->sample.count <= 2000 ? 1 : d->sample.count <= 10000 ? 0.7 : 0.4);
    cairo_stroke(c->cr);
    return any;
}

static void draw_all_messages(const struct canvas *c, const struct space_time *d)
{
    struct legend_entry list[ENDS];
    bool any[ENDS];
    size_t count = 0;
    cairo_save(c->cr);
    cairo_rectangle(c->cr, d->plot.x, d->plot.y, d->plot.w, d->plot.h);
    cairo_clip(c->cr);
    for (int end = ENDS - 1; end >= 0; end--)
        any[end] = draw_messages(c, d, (enum end)end);
    cairo_restore(c->cr);
    for (int end = 0; end < ENDS; end++)
        if (any[end])
            list[count++] =
                (struct legend_entry){COLOUR(END_LOOKS[end].colour), xstrdup(END_LOOKS[end].text), true};
    legend(c, d->plot.x, d->plot.y + d->plot.h + (has_bands(d) ? 80 : 60), list, count);
}

static char *notes(const struct space_time *d)
{
    if (d->show->densest && d->sample.count == (size_t)d->show->trace->message_count)
        return xasprintf("Where all %s messages are; --messages N draws the whole run",
                         number_grouped(d->sample.count).text);
    if (d->show->densest)
        return xasprintf("Where messages are the densest: %zu of %s%s; --messages N draws the whole run",
                         d->sample.count, number_grouped((uint64_t)d->show->trace->message_count).text,
                         d->sample.count < d->sample.of ? ", evenly chosen" : "");
    char *lines = d->apart < 4 ? xasprintf("%d lines, too close to be drawn; ", d->lines.count) : xstrdup("");
    struct number_text count = number_grouped(d->sample.count), of = number_grouped(d->sample.of);
    char *text = d->sample.count < d->sample.of
                     ? xasprintf("%s%s of %s messages drawn, evenly chosen", lines, count.text, of.text)
                 : d->sample.of ? xasprintf("%sall %s messages drawn", lines, of.text)
                                : xasprintf("%sno message is on its way", lines);
    free(lines);
    return text;
}

/* So many messages that their lines cover a part of the plot, and what is behind them can be seen. */
static size_t room_for_messages(const struct space_time *d)
{
    const double part = 0.2, width = 0.7;
    double length = 1;
    for (size_t i = 0; i < d->sample.count; i++) {
        struct line l = line_of(d, &d->show->trace->messages[d->sample.list[i]], 0);
        length += hypot(l.x2 - l.x1, l.y2 - l.y1);
    }
    return (size_t)(part * d->plot.w * d->plot.h / (width * length / (double)(d->sample.count + 1)));
}

static void choose_messages(struct space_time *d)
{
    const struct show *s = d->show;
    d->sample = message_sample_make(s->trace, &d->lines, s->most_lines ? s->most_lines : MOST_UNASKED);
    size_t room = room_for_messages(d);
    if (s->most_lines || d->sample.count <= room)
        return;
    message_sample_free(&d->sample);
    d->sample = message_sample_make(s->trace, &d->lines, room);
}

/* A message's time. */
struct way {
    vtime sent, length;
};

static int by_sent(const void *a, const void *b)
{
    vtime x = ((const struct way *)a)->sent, y = ((const struct way *)b)->sent;
    return x < y ? -1 : x > y;
}

static int by_length(const void *a, const void *b)
{
    vtime x = ((const struct way *)a)->length, y = ((const struct way *)b)->length;
    return x < y ? -1 : x > y;
}

/* Narrows the trace's interval to the shortest one in which so many of the sampled messages are sent, and
 * half of them arrive, or all if these are all messages: all nodes may send at one moment. */
static void narrow(const struct message_sample *all, size_t most, struct trace *t)
{
    struct way *ways = xcalloc(all->count, sizeof *ways);
    size_t best = 0;
    for (size_t i = 0; i < all->count; i++) {
        const struct trace_message *m = &t->messages[all->list[i]];
        ways[i] = (struct way){m->sent, m->complete == VT_NEVER ? 0 : m->complete - m->sent};
    }
    qsort(ways, all->count, sizeof *ways, by_sent);
    for (size_t i = 1; i + most <= all->count; i++)
        if (ways[i + most - 1].sent - ways[i].sent < ways[best + most - 1].sent - ways[best].sent)
            best = i;
    vtime first = ways[best].sent, last = ways[best + most - 1].sent;
    qsort(ways + best, most, sizeof *ways, by_length);
    last += ways[most < all->count ? best + most / 2 : most - 1].length;
    vtime room = (last - first) / 20 + 1, from = first > room ? first - room : 0;
    t->from = from > t->from ? from : t->from;
    t->to = vt_min(last + room, t->to);
    free(ways);
}

/* Are all of these messages in so small a part of the run that none could be seen? */
static bool is_crowded(const struct message_sample *all, const struct trace *t)
{
    const vtime PARTS = 10;
    vtime first = t->to, last = t->from;
    for (size_t i = 0; i < all->count; i++) {
        const struct trace_message *m = &t->messages[all->list[i]];
        first = vt_min(first, m->sent);
        last = vt_max(last, m->complete == VT_NEVER ? m->sent : m->complete);
    }
    return all->count > 0 && last - first < (t->to - t->from) / PARTS;
}

/* Chooses the interval in which messages are the densest, if there are more of them than have room, or if all
 * are crowded in a small part of the run. Returns whether it has chosen one. */
static bool choose_interval(struct space_time *d, struct trace *t)
{
    struct message_sample all = message_sample_make(t, &d->lines, SIZE_MAX);
    d->sample = message_sample_make(t, &d->lines, MOST_UNASKED);
    size_t room = room_for_messages(d), most = room < SCREENFUL ? room : SCREENFUL;
    bool part = (all.count > most && most > 1) || is_crowded(&all, t);
    if (part)
        narrow(&all, all.count < most ? all.count : most, t);
    message_sample_free(&d->sample);
    message_sample_free(&all);
    return part;
}

void space_time_draw(const struct show *asked, const struct canvas *c)
{
    struct show part = *asked, *s = &part;
    struct trace narrowed = *asked->trace;
    struct space_time d = {.show = s, .lines = node_rows_single(s->trace)};
    d.apart = lines_apart(d.lines.count);
    d.plot = (struct plot){LEFT, HEAD_HEIGHT, CANVAS_WIDTH - LEFT - 24, d.lines.count * d.apart};
    part.densest = asked->densest && choose_interval(&d, &narrowed);
    part.trace = &narrowed;
    choose_messages(&d);
    show_head(s, c, "Space-time diagram", notes(&d));
    draw_lines(c, &d);
    draw_all_messages(c, &d);
    canvas_frame(c, d.plot);
    axes_rows(c, d.plot, &d.lines, s->trace, "node");
    axes_time(c, d.plot, s->trace->from, s->trace->to);
    message_sample_free(&d.sample);
    node_rows_free(&d.lines);
}
