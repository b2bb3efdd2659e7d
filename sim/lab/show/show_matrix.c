/* show_matrix.c - the communication matrix: what each node, or class of nodes, sent to each. */
#include <math.h>
#include <stdlib.h>
#include "files/number.h"
#include "kernel/xalloc.h"
#include "lab/draw/axes.h"
#include "lab/show/display_parts.h"
#include "lab/draw/heat.h"
#include "lab/show/message_matrix.h"

enum { FAR_APART = 50 }; /* a given scale up to more is logarithmic */
enum { SIDE = 520, BARS = 70, GAP = 10, MOST_NUMBERS = 16, MOST_BYTES = 12 };

struct matrix_picture {
    struct message_matrix m;
    bool by_bytes;
    double *sent, *received; /* by row */
    double least, most;      /* of cells above 0 */
};

static double amount(const void *ctx, uint32_t to, uint32_t from)
{
    const struct matrix_picture *x = ctx;
    const struct message_sum *cell = message_matrix_at(&x->m, (int32_t)from, (int32_t)to);
    return (double)(x->by_bytes ? cell->bytes : cell->messages);
}

static struct matrix_picture measure(const struct show *s)
{
    struct matrix_picture x = {.m = message_matrix_make(s->trace, &s->rows), .by_bytes = s->by_bytes};
    uint32_t size = (uint32_t)x.m.size;
    x.sent = xcalloc(size, sizeof *x.sent);
    x.received = xcalloc(size, sizeof *x.received);
    for (uint32_t from = 0; from < size; from++)
        for (uint32_t to = 0; to < size; to++) {
            double v = amount(&x, to, from);
            x.sent[from] += v, x.received[to] += v;
            x.most = fmax(x.most, v);
            x.least = v > 0 && (x.least <= 0 || v < x.least) ? v : x.least;
        }
    return x;
}

double matrix_height(const struct show *s)
{
    (void)s;
    return HEAD_HEIGHT + SIDE + 50 + BARS + 24;
}

static char *notes(const struct show *s, const struct matrix_picture *x)
{
    char *bytes = axis_number_text((double)x->m.bytes, true);
    char *rows = s->rows.per > 1 ? node_rows_text(&s->rows, "rows") : xstrdup("");
    char *text = xasprintf(
        "%s message%s sent, %s%s%s; white: none; bars: all that a row sent, and a column received",
        number_grouped(x->m.messages).text, x->m.messages == 1 ? "" : "s", bytes, *rows ? "; " : "", rows);
    free(bytes);
    free(rows);
    return text;
}

/* The sums of rows, right of the matrix, and of columns, below. */
static void draw_bars(const struct canvas *c, struct plot p, const struct matrix_picture *x)
{
    const struct text_style style = {10, INK, ANCHOR_LEFT, false};
    double most = 0, step = p.w / x->m.size;
    for (int32_t i = 0; i < x->m.size; i++)
        most = fmax(most, fmax(x->sent[i], x->received[i]));
    double right = p.x + p.w + GAP, below = p.y + p.h + 44;
    for (int32_t i = 0; most > 0 && i < x->m.size; i++) {
        double thick = step > 4 ? step - 1 : step;
        canvas_fill(c, (struct plot){right, p.y + i * step, x->sent[i] / most * BARS, thick}, GREY);
        canvas_fill(c, (struct plot){p.x + i * step, below, thick, x->received[i] / most * BARS}, GREY);
    }
    char *text = axis_number_text(most, x->by_bytes);
    canvas_line(c, right, p.y - 4, right + BARS, p.y - 4, 1, INK);
    canvas_text(c, right, p.y - 10, style, "sent");
    canvas_text(c, right + BARS, p.y - 10, (struct text_style){10, INK, ANCHOR_RIGHT, false}, text);
    canvas_line(c, p.x - 4, below, p.x - 4, below + BARS, 1, INK);
    canvas_text(c, p.x - 8, below + 8, (struct text_style){10, INK, ANCHOR_RIGHT, false}, "received");
    canvas_text(c, p.x - 8, below + BARS, (struct text_style){10, INK, ANCHOR_RIGHT, false}, text);
    free(text);
}

static void draw_numbers(const struct canvas *c, struct plot p, const struct matrix_picture *x,
                         const struct heat *h)
{
    double step = p.w / x->m.size;
    for (uint32_t from = 0; from < (uint32_t)x->m.size; from++)
        for (uint32_t to = 0; to < (uint32_t)x->m.size; to++) {
            double v = amount(x, to, from);
            if (v <= 0)
                continue;
            char *text = axis_number_text(v, x->by_bytes);
            struct colour colour = palette_is_dark(heat_level(h, v)) ? COLOUR(0xffffff) : INK;
            canvas_text(c, p.x + (to + 0.5) * step, p.y + (from + 0.5) * step + 3.5,
                        (struct text_style){x->by_bytes ? 9 : 10, colour, ANCHOR_MIDDLE, false}, text);
            free(text);
        }
}

static void draw_others(const struct canvas *c, struct plot p, int32_t size)
{
    double step = p.w / size;
    canvas_text(c, p.x - 7, p.y + p.h - step / 2 + 3.5, (struct text_style){10, INK, ANCHOR_RIGHT, false},
                "others");
    canvas_text(c, p.x + p.w, p.y + p.h + 15, (struct text_style){10, INK, ANCHOR_RIGHT, false}, "others");
    canvas_line(c, p.x, p.y + p.h - step, p.x + p.w, p.y + p.h - step, 0.5, GREY);
    canvas_line(c, p.x + p.w - step, p.y, p.x + p.w - step, p.y + p.h, 0.5, GREY);
}

void matrix_draw(const struct show *s, const struct canvas *c)
{
    struct matrix_picture x = measure(s);
    struct heat h = s->most_amount > 0 ? heat_given(s->most_amount, s->most_amount >= FAR_APART)
                                       : heat_scale(x.least, x.most);
    struct plot p = {LEFT, HEAD_HEIGHT + 8, SIDE, SIDE}, nodes = p;
    nodes.w = nodes.h = SIDE * (double)s->rows.count / x.m.size;
    show_head(s, c, s->by_bytes ? "Communication matrix: bytes" : "Communication matrix: messages",
              notes(s, &x));
    heat_grid(c, p, &h, (uint32_t)x.m.size, (uint32_t)x.m.size, 0, amount, &x);
    if (x.m.size <= (s->by_bytes ? MOST_BYTES : MOST_NUMBERS))
        draw_numbers(c, p, &x, &h);
    if (x.m.others)
        draw_others(c, p, x.m.size);
    canvas_frame(c, p);
    axes_rows(c, nodes, &s->rows, s->trace, "from node");
    axes_columns(c, nodes, &s->rows, s->trace, "to node");
    draw_bars(c, p, &x);
    heat_bar(c, (struct plot){p.x + p.w + BARS + 60, p.y + 20, 14, 300}, &h,
             s->by_bytes ? HEAT_BYTES : HEAT_NUMBER,
             s->by_bytes ? "bytes from a row to a column" : "messages from a row to a column");
    message_matrix_free(&x.m);
    free(x.sent);
    free(x.received);
}
