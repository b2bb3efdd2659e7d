/* show_lengths.c - the histogram of message lengths: by number, and by the bytes they carry. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include "files/number.h"
#include "kernel/xalloc.h"
#include "lab/draw/axes.h"
#include "lab/show/display_parts.h"
#include "lab/show/message_lengths.h"

enum { PANEL = 190 };
static const uint32_t SHORT = 0x004488, LONG = 0xe6b93d;

double lengths_height(const struct show *s)
{
    (void)s;
    return HEAD_HEIGHT + 2 * PANEL + 50 + 80;
}

static char *notes(const struct message_lengths *l)
{
    if (!l->messages)
        return xstrdup("No message was sent");
    char *bytes = axis_number_text((double)l->bytes, true);
    char *text = xasprintf("%s message%s, %s; the shortest has %" PRIu64 " bytes, the median %" PRIu64
                           ", the longest %s; classes by powers of two",
                           number_grouped(l->messages).text, l->messages == 1 ? "" : "s", bytes, l->shortest,
                           l->median, number_grouped(l->longest).text);
    free(bytes);
    return text;
}

/* The lower end of a class, as "512" or "4 Ki". malloc'd. */
static char *edge_text(int class)
{
    static const char *const PREFIXES[] = {"", " Ki", " Mi", " Gi", " Ti", " Pi", " Ei"};
    int bit = class - 1;
    return class == 0 ? xstrdup("0") : xasprintf("%d%s", 1 << bit % 10, PREFIXES[bit / 10]);
}

static double value_of(const struct message_lengths *l, int class, int is_long, bool bytes)
{
    const struct message_sum *sum = &l->sums[class][is_long];
    return (double)(bytes ? sum->bytes : sum->messages);
}

/* A class's bar: short messages below, long ones above, and the sum as a text. */
static void draw_bar(const struct canvas *c, struct plot bar, const double values[2], double most, bool bytes)
{
    double bottom = bar.y + bar.h;
    for (int is_long = 0; is_long < 2; is_long++) {
        double h = values[is_long] / most * bar.h;
        canvas_fill(c, (struct plot){bar.x, bottom - h, bar.w, h}, COLOUR(is_long ? LONG : SHORT));
        bottom -= h;
    }
    if (values[0] + values[1] <= 0)
        return;
    char *text = axis_number_text(values[0] + values[1], bytes);
    canvas_text(c, bar.x + bar.w / 2, bottom - 4, (struct text_style){9.5, INK, ANCHOR_MIDDLE, false}, text);
    free(text);
}

static void draw_panel(const struct canvas *c, struct plot p, const struct message_lengths *l, bool bytes)
{
    int first = l->first_class, count = l->last_class - first + 1;
    double most = 0, width = p.w / count;
    for (int k = first; k <= l->last_class; k++)
        most = fmax(most, value_of(l, k, 0, bytes) + value_of(l, k, 1, bytes));
    most = most > 0 ? most * 1.12 : 1; /* room for the text */
    for (int k = first; k <= l->last_class; k++) {
        double values[2] = {value_of(l, k, 0, bytes), value_of(l, k, 1, bytes)};
        draw_bar(c, (struct plot){p.x + (k - first) * width + width * 0.06, p.y, width * 0.88, p.h}, values,
                 most, bytes);
    }
    canvas_frame(c, p);
    axes_number(c, p, most, bytes, bytes ? "bytes they carry" : "messages");
}

/* The lengths at the edges of classes; the class of no bytes has its length in its middle. */
static void draw_edges(const struct canvas *c, struct plot p, const struct message_lengths *l)
{
    const struct text_style style = {10, INK, ANCHOR_MIDDLE, false};
    double width = p.w / (l->last_class - l->first_class + 1), bottom = p.y + p.h;
    for (int k = l->first_class; k <= l->last_class + 1; k++) {
        double x = p.x + (k - l->first_class + (k ? 0 : 0.5)) * width;
        char *text = edge_text(k);
        canvas_line(c, x, bottom, x, bottom + 5, 1, INK);
        canvas_text(c, x, bottom + 17, style, text);
        free(text);
    }
    canvas_text(c, p.x + p.w / 2, bottom + 35, (struct text_style){11, INK, ANCHOR_MIDDLE, false},
                "length of the message (bytes)");
}

void lengths_draw(const struct show *s, const struct canvas *c)
{
    struct message_lengths l = message_lengths_make(s->trace, &s->rows);
    struct plot above = {LEFT, HEAD_HEIGHT, CANVAS_WIDTH - LEFT - 30, PANEL}, below = above;
    below.y += PANEL + 26;
    show_head(s, c, "Message lengths", notes(&l));
    if (!l.messages)
        return;
    draw_panel(c, above, &l, false);
    draw_panel(c, below, &l, true);
    draw_edges(c, below, &l);
    struct legend_entry list[] = {
        {COLOUR(SHORT), xstrdup("sent at once"), false},
        {COLOUR(LONG), xstrdup("long: sent when the receiver has cleared it to send (three trips)"), false}};
    legend(c, below.x, below.y + PANEL + 62, list, 2);
}
