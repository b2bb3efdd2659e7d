/* show_queues.c - the messages that nodes have not taken: all nodes' together, and node by node, over
 * time. */
#include <math.h>
#include <stdlib.h>
#include "files/number.h"
#include "kernel/xalloc.h"
#include "lab/draw/axes.h"
#include "lab/show/display_parts.h"
#include "lab/draw/heat.h"
#include "lab/show/message_queues.h"

enum { ABOVE = 130, BETWEEN = 26, RIGHT = 120, LEAST_BAR = 60, SVG_COLUMNS = 240 };
static const uint32_t COLOURS[QUEUE_KINDS] = {[QUEUE_WAITING] = 0xbb5566, [QUEUE_COMING] = 0x9fc1e4};

static double row_height(const struct show *s)
{
    return show_row_height(s->rows.count, 330, 4, 30);
}

double queues_height(const struct show *s)
{
    return HEAD_HEIGHT + ABOVE + BETWEEN + s->rows.count * row_height(s) + 76;
}

/* Of a row: all its nodes' messages. */
static double waiting(const void *ctx, uint32_t bin, uint32_t row)
{
    return message_queues_mean(ctx, (int32_t)row, bin, QUEUE_WAITING);
}

/* All nodes' messages of the first `kinds` kinds in a bin. */
static double all_rows(const struct message_queues *q, uint32_t bin, int kinds)
{
    double sum = 0;
    for (int32_t row = 0; row < q->rows; row++)
        for (int k = 0; k < kinds; k++)
            sum += message_queues_mean(q, row, bin, (enum queue_kind)k);
    return sum;
}

static double most_of_all(const struct message_queues *q)
{
    double most = 0;
    for (uint32_t bin = 0; bin < q->bins.count; bin++)
        most = fmax(most, all_rows(q, bin, QUEUE_KINDS));
    return most;
}

static void draw_all(const struct canvas *c, struct plot p, const struct message_queues *q)
{
    double most = most_of_all(q), width = p.w / q->bins.count;
    for (int kinds = QUEUE_KINDS; kinds > 0; kinds--) {
        cairo_move_to(c->cr, p.x, p.y + p.h);
        for (uint32_t bin = 0; most > 0 && bin < q->bins.count; bin++) {
            double y = p.y + p.h - canvas_round(c, all_rows(q, bin, kinds) / most * p.h);
            cairo_line_to(c->cr, p.x + bin * width, y);
            cairo_line_to(c->cr, p.x + (bin + 1) * width, y);
        }
        cairo_line_to(c->cr, p.x + p.w, p.y + p.h);
        cairo_close_path(c->cr);
        canvas_colour(c, COLOUR(COLOURS[kinds - 1]));
        cairo_fill(c->cr);
    }
    canvas_frame(c, p);
    axes_number(c, p, most > 0 ? most : 1, q->bytes, q->bytes ? "bytes, all nodes" : "all nodes");
}

/* "1,432 messages at node 0, at 54.2 s". malloc'd. */
static char *longest_text(const struct trace *t, const struct message_queues *q)
{
    uint64_t length = q->longest.length;
    char *time = axis_time_text(q->longest.time, (q->bins.to - q->bins.from) / 1000);
    char *count = q->bytes ? axis_number_text((double)length, true) : xstrdup(number_grouped(length).text);
    const char *what = q->bytes ? "" : length == 1 ? " message" : " messages";
    char *text = xasprintf("%s%s at %s, at %s", count, what, t->nodes[q->longest.node].name, time);
    free(time);
    free(count);
    return text;
}

static char *notes(const struct show *s, const struct message_queues *q)
{
    char *rows = s->rows.per > 1 ? node_rows_text(&s->rows, "rows") : xstrdup("");
    char *longest = q->longest.node == TRACE_NONE ? xstrdup("none") : longest_text(s->trace, q);
    char *text =
        xasprintf("%s%sthe longest queue of messages that wait: %s", rows, *rows ? "; " : "", longest);
    free(rows);
    free(longest);
    return text;
}

static double most_of_rows(const struct message_queues *q)
{
    double most = 0;
    for (uint32_t row = 0; row < (uint32_t)q->rows; row++)
        for (uint32_t bin = 0; bin < q->bins.count; bin++)
            most = fmax(most, waiting(q, bin, row));
    return most;
}

void queues_draw(const struct show *s, const struct canvas *c)
{
    struct plot above = {LEFT, HEAD_HEIGHT, CANVAS_WIDTH - LEFT - RIGHT, ABOVE}, below = above;
    uint32_t columns = c->vector ? SVG_COLUMNS : (uint32_t)above.w * CANVAS_PIXELS;
    struct time_bins bins = time_bins_make(s->trace->from, s->trace->to, columns);
    struct message_queues q = message_queues_make(s->trace, &s->rows, bins, s->by_bytes);
    struct heat h = heat_linear(most_of_rows(&q));
    below.y += ABOVE + BETWEEN, below.h = s->rows.count * row_height(s);
    show_head(s, c, s->by_bytes ? "Message queues: bytes" : "Message queues: messages", notes(s, &q));
    draw_all(c, above, &q);
    heat_grid(c, below, &h, bins.count, (uint32_t)s->rows.count, row_height(s) > 8 ? 1 : 0, waiting, &q);
    canvas_frame(c, below);
    axes_rows(c, below, &s->rows, s->trace, "node");
    axes_time(c, below, s->trace->from, s->trace->to);
    heat_bar(
        c, (struct plot){below.x + below.w + 20, below.y + 16, 14, fmin(fmax(below.h - 16, LEAST_BAR), 240)},
        &h, s->by_bytes ? HEAT_BYTES : HEAT_NUMBER, "waiting, in a row");
    struct legend_entry list[] = {
        {COLOUR(COLOURS[QUEUE_WAITING]), xstrdup("complete, and waiting until its program takes it"), false},
        {COLOUR(COLOURS[QUEUE_COMING]), xstrdup("on its way"), false}};
    legend(c, below.x, below.y + below.h + 60, list, QUEUE_KINDS);
    message_queues_free(&q);
}
