/* deadlock_draw.c - see deadlock_draw.h. */
#include "lab/deadlock/deadlock_draw.h"
#include <cairo/cairo-svg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "files/number_ranges.h"
#include "files/text_file.h"
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "lab/deadlock/deadlock_edges.h"

/* With more boxes, edges to all that could end a wait would hide the rest: the boxes say it in words. */
enum { MOST_BOXES_WITH_ANY = 8, MOST_TEXT = 160 };

struct picture {
    struct deadlock_graph *graph;
    struct deadlock_layout layout;
};

/* --- texts --- */

/* Shortened until it fits into a width. */
static void put_text(const struct canvas *c, double x, double y, double width, struct text_style style,
                     const char *text)
{
    char s[MOST_TEXT];
    size_t length = text_cut(text, sizeof s - 4);
    memcpy(s, text, length);
    s[length] = '\0';
    while (length > 1 && canvas_text_width(c, style, s) > width) {
        length = text_cut(s, length - 1);
        memcpy(s + length, "\u2026", sizeof "\u2026");
    }
    canvas_text(c, x, y, style, s);
}

/* "node 3", "nodes 1-5, 7", "host", "506 nodes more". malloc'd. */
static char *title_of(const struct deadlock_graph *g, const struct deadlock_box *b)
{
    char *text;
    size_t size;
    if (b->count == 1)
        return xstrdup(b->like->name ? b->like->name : "");
    if (b->in_cycle)
        return xasprintf("%u nodes more", b->count);
    FILE *f = xchecked(open_memstream(&text, &size));
    uint32_t count = b->count - (g->w->nodes[b->nodes[b->count - 1]].is_host ? 1 : 0);
    number_ranges_print_nodes(f, b->nodes, count);
    fprintf(f, "%s", count < b->count ? ", host" : "");
    fclose(f);
    return text;
}

/* "crecv(7), ring.c:42". malloc'd. */
static char *place_of(const struct deadlock_box *b)
{
    const struct waitfor_node *n = b->like;
    if (b->mixed)
        return xstrdup("in other states");
    if (n->exit_status)
        return xasprintf("ended with exit(%d)", n->exit_status);
    if (n->state != WAITFOR_WAITS)
        return xstrdup(n->state == WAITFOR_ENDED        ? "ended"
                       : n->state == WAITFOR_NO_PROGRAM ? "no program"
                                                        : "computing");
    char *type = n->has_type && !n->operation ? xasprintf("(%ld)", n->type) : xstrdup("");
    char *text = xasprintf("%s%s%s%s",
                           n->operation ? n->operation
                           : n->call    ? n->call
                                        : "",
                           type, n->line ? ", " : "", n->line ? n->line : "");
    free(type);
    return text;
}

/* What is awaited: the label of edges. malloc'd. */
static char *awaited_of(const struct waitfor_node *n)
{
    switch (n->what) {
    case WAITFOR_MESSAGE:
        return n->operation              ? xstrdup(n->operation)
               : n->select.typesel == -1 ? xstrdup("any type")
               : n->select.typesel < 0   ? xstrdup("one of several types")
                                         : xasprintf("type %ld", n->select.typesel);
    case WAITFOR_BUFFER:
        return xasprintf("room for %zu bytes", n->to_bytes);
    case WAITFOR_END:
        return xstrdup("its end");
    case WAITFOR_HANDLER:
        return xstrdup("a handler");
    default:
        return xstrdup(n->call ? n->call : "");
    }
}

static bool waits(const struct deadlock_box *b)
{
    return b->mixed || b->like->state == WAITFOR_WAITS;
}

/* Why, in a few words. malloc'd. */
static char *cause_of(const struct deadlock_box *b)
{
    const struct waitfor_node *n = b->like;
    if (b->mixed || n->state != WAITFOR_WAITS)
        return xstrdup("");
    char *awaited = awaited_of(n);
    const char *cause = waitfor_cause_name(n->cause);
    char *text = n->who == WAITFOR_ANY_NODE ? xasprintf("%s (%s, any node)", cause, awaited)
                 : n->who == WAITFOR_NOBODY ? xasprintf("%s (%s)", cause, awaited)
                                            : xstrdup(cause);
    free(awaited);
    return text;
}

/* Does the box tell a reason of its own, and not only that others hold it up? */
static bool is_reason(const struct deadlock_box *b)
{
    const struct waitfor_node *n = b->like;
    return !b->mixed && n->state == WAITFOR_WAITS && n->cause != WAITFOR_CYCLE && n->cause != WAITFOR_KNOT &&
           n->cause != WAITFOR_BEHIND;
}

/* --- boxes --- */

static void draw_box(const struct canvas *c, const struct deadlock_graph *g, const struct deadlock_box *b,
                     struct plot p)
{
    char *title = title_of(g, b), *place = place_of(b), *cause = cause_of(b);
    canvas_fill(c, p, COLOUR(waits(b) ? 0xffffff : 0xdddddd));
    canvas_colour(c, b->in_cycle || is_reason(b) ? INK : GREY);
    cairo_set_line_width(c->cr, b->in_cycle ? 3.2 : is_reason(b) ? 2.2 : 1);
    cairo_rectangle(c->cr, p.x, p.y, p.w, p.h);
    cairo_stroke(c->cr);
    if (b->count > 1) /* a second sheet behind it */
        canvas_line(c, p.x + 4, p.y + p.h + 4, p.x + p.w + 4, p.y + p.h + 4, 1, GREY),
            canvas_line(c, p.x + p.w + 4, p.y + 4, p.x + p.w + 4, p.y + p.h + 4, 1, GREY);
    double x = p.x + p.w / 2, width = p.w - 12;
    put_text(c, x, p.y + 18, width, (struct text_style){12.5, INK, ANCHOR_MIDDLE, true}, title);
    put_text(c, x, p.y + 34, width, (struct text_style){11, INK, ANCHOR_MIDDLE, false}, place);
    put_text(c, x, p.y + 49, width, (struct text_style){10, INK, ANCHOR_MIDDLE, is_reason(b)}, cause);
    free(title);
    free(place);
    free(cause);
}

/* --- the picture --- */

static bool is_drawn(const struct deadlock_graph *g, const struct deadlock_edge *e)
{
    return e->kind != WAITFOR_ANY_NODE || g->count <= MOST_BOXES_WITH_ANY;
}

/* The cycle over the others. */
static void draw_edges(const struct canvas *c, const struct picture *p)
{
    const struct deadlock_graph *g = p->graph;
    for (int cycle = 0; cycle < 2; cycle++)
        for (uint32_t i = 0; i < g->edge_count; i++)
            if (g->edges[i].in_cycle == cycle && is_drawn(g, &g->edges[i]))
                deadlock_edge_draw(c, &p->layout, &g->edges[i]);
}

/* What is awaited of any node, and the name of a global operation, stand in the boxes. */
static void draw_labels(const struct canvas *c, const struct picture *p)
{
    const struct deadlock_graph *g = p->graph;
    struct deadlock_labels labels = {0};
    for (int other = 0; other < 2; other++)
        for (uint32_t i = 0; i < g->edge_count; i++) {
            const struct deadlock_edge *e = &g->edges[i];
            if (e->in_cycle == other || e->kind != WAITFOR_ONE_NODE)
                continue;
            char *text = awaited_of(g->boxes[e->from].like);
            deadlock_edge_label(c, g, &p->layout, e, text, &labels);
            free(text);
        }
    free(labels.taken);
}

char *deadlock_draw_summary(const struct waitfor *w)
{
    uint32_t waiting = 0, in_knot = 0;
    for (uint32_t i = 0; i < w->count; i++) {
        waiting += w->nodes[i].state == WAITFOR_WAITS;
        in_knot += w->nodes[i].cause == WAITFOR_KNOT;
    }
    if (w->cycle_count)
        return xasprintf("%u of %u programs wait; a cycle of %u: each waits for the next", waiting, w->count,
                         w->cycle_count);
    if (in_knot)
        return xasprintf("%u of %u programs wait; a knot: each for a message that any other could send",
                         waiting, w->count);
    return xasprintf("%u of %u programs wait; no cycle: what has a thick frame has a reason of its own",
                     waiting, w->count);
}

static void draw_head(const struct canvas *c, const struct waitfor *w)
{
    char *what = xasprintf("%s \u00b7 at %s of %s", w->program ? basename(w->program) : "a program",
                           virtual_time_moment(w->now_ps).text, w->clock ? w->clock : "time");
    char *summary = deadlock_draw_summary(w);
    canvas_text(c, 24, 30, (struct text_style){17, INK, ANCHOR_LEFT, true}, "Deadlock: who waits for whom");
    canvas_text(c, 24, 48, (struct text_style){11.5, INK, ANCHOR_LEFT, false}, what);
    canvas_text(c, 24, 64, (struct text_style){10.5, GREY, ANCHOR_LEFT, false}, summary);
    free(what);
    free(summary);
}

char *deadlock_draw_legend(const struct deadlock_graph *g)
{
    bool dashed = false, grey = false, several = false;
    uint32_t arrows = 0;
    for (uint32_t i = 0; i < g->edge_count; i++) {
        arrows += is_drawn(g, &g->edges[i]);
        dashed = dashed || (is_drawn(g, &g->edges[i]) && g->edges[i].kind == WAITFOR_ANY_NODE);
    }
    for (uint32_t i = 0; i < g->count; i++) {
        grey = grey || !waits(&g->boxes[i]);
        several = several || g->boxes[i].count > 1;
    }
    return xasprintf("%s%s%s%s%s", arrows ? "An arrow leads to the node that could end the wait." : "",
                     g->cycle_count ? " Thick: the cycle." : "",
                     dashed ? " Dashed: any one of these would do." : "",
                     grey ? " Grey box: does not wait." : "", several ? " Double box: several nodes." : "");
}

static void draw(void *ctx, const struct canvas *c)
{
    const struct picture *p = ctx;
    const struct deadlock_graph *g = p->graph;
    draw_head(c, g->w);
    draw_edges(c, p);
    draw_labels(c, p);
    for (uint32_t k = 0; k < g->count; k++)
        draw_box(c, g, &g->boxes[k], p->layout.places[k]);
    char *legend = deadlock_draw_legend(g);
    canvas_text(c, 24, c->height - 16, (struct text_style){10.5, GREY, ANCHOR_LEFT, false}, legend);
    free(legend);
}

static struct picture picture_of(const struct waitfor *w)
{
    struct picture p = {.graph = deadlock_graph_make(w)};
    p.layout = deadlock_layout_make(p.graph);
    return p;
}

static void picture_free(struct picture *p)
{
    free(p->layout.places);
    deadlock_graph_free(p->graph);
}

bool deadlock_draw_file(const struct waitfor *w, const char *path, enum picture_kind kind, char **error)
{
    struct picture p = picture_of(w);
    bool ok = picture_write(path, kind, p.layout.height, draw, &p, error);
    picture_free(&p);
    return ok;
}

static cairo_status_t add_bytes(void *out, const unsigned char *data, unsigned length)
{
    return fwrite(data, 1, length, out) == length ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

char *deadlock_draw_svg(const struct waitfor *w)
{
    char *text;
    size_t size;
    struct picture p = picture_of(w);
    FILE *f = xchecked(open_memstream(&text, &size));
    double height = ceil(p.layout.height);
    cairo_surface_t *surface = cairo_svg_surface_create_for_stream(add_bytes, f, CANVAS_WIDTH, height);
    struct canvas c = {cairo_create(surface), true, CANVAS_WIDTH, height};
    canvas_fill(&c, (struct plot){0, 0, CANVAS_WIDTH, height}, COLOUR(0xffffff));
    draw(&p, &c);
    cairo_destroy(c.cr);
    cairo_surface_destroy(surface);
    fclose(f);
    picture_free(&p);
    return text;
}
