/* deadlock_edges.c - see deadlock_edges.h. */
#include "lab/deadlock/deadlock_edges.h"
#include <math.h>
#include "kernel/xalloc.h"

enum { STEPS = 240, EVERY = 8 };

struct point {
    double x, y;
};

/* A cubic curve. */
struct curve {
    struct point p[4];
};

static struct point at(const struct curve *c, double t)
{
    double u = 1 - t, a = u * u * u, b = 3 * u * u * t, d = 3 * u * t * t, e = t * t * t;
    return (struct point){a * c->p[0].x + b * c->p[1].x + d * c->p[2].x + e * c->p[3].x,
                          a * c->p[0].y + b * c->p[1].y + d * c->p[2].y + e * c->p[3].y};
}

static bool lies_in(struct point p, struct plot a, double margin)
{
    return p.x > a.x - margin && p.x < a.x + a.w + margin && p.y > a.y - margin && p.y < a.y + a.h + margin;
}

static struct point middle(struct plot a)
{
    return (struct point){a.x + a.w / 2, a.y + a.h / 2};
}

/* Bent to its left, so that the edges there and back lie apart. */
static struct curve between(struct plot from, struct plot to)
{
    struct point a = middle(from), b = middle(to);
    double dx = b.x - a.x, dy = b.y - a.y, bend = 0.14;
    struct point m1 = {a.x + dx / 3 + dy * bend, a.y + dy / 3 - dx * bend};
    struct point m2 = {a.x + 2 * dx / 3 + dy * bend, a.y + 2 * dy / 3 - dx * bend};
    return (struct curve){{a, m1, m2, b}};
}

/* From a box's right side, over its corner, to its top. */
static struct curve to_itself(struct plot box)
{
    double right = box.x + box.w;
    return (struct curve){{{right - 20, box.y + 30},
                           {right + 48, box.y + 12},
                           {right + 4, box.y - 50},
                           {right - 34, box.y + 10}}};
}

static void draw_head(const struct canvas *c, struct point tip, struct point before, double size)
{
    double turn = atan2(tip.y - before.y, tip.x - before.x), wide = 0.42;
    cairo_set_dash(c->cr, NULL, 0, 0);
    cairo_move_to(c->cr, canvas_round(c, tip.x), canvas_round(c, tip.y));
    for (int side = -1; side <= 1; side += 2)
        cairo_line_to(c->cr, canvas_round(c, tip.x - size * cos(turn + side * wide)),
                      canvas_round(c, tip.y - size * sin(turn + side * wide)));
    cairo_close_path(c->cr);
    cairo_fill(c->cr);
}

/* The part of the curve between leaving one box and reaching the other. */
static void draw_part(const struct canvas *c, const struct curve *k, int first, int last, double head)
{
    struct point p = at(k, (double)first / STEPS), tip = at(k, (double)last / STEPS);
    cairo_move_to(c->cr, canvas_round(c, p.x), canvas_round(c, p.y));
    for (int i = first + EVERY; i < last - EVERY; i += EVERY) {
        p = at(k, (double)i / STEPS);
        cairo_line_to(c->cr, canvas_round(c, p.x), canvas_round(c, p.y));
    }
    struct point base = at(k, (double)(last > first + EVERY ? last - EVERY / 2 : first) / STEPS);
    cairo_line_to(c->cr, canvas_round(c, base.x), canvas_round(c, base.y));
    cairo_stroke(c->cr);
    draw_head(c, tip, base, head);
}

/* The part of an edge's curve that lies outside of its boxes. */
struct span {
    struct curve curve;
    int first, last; /* of STEPS */
};

static struct span span_of(const struct deadlock_layout *l, const struct deadlock_edge *e)
{
    struct plot from = l->places[e->from], to = l->places[e->to];
    struct span s = {e->from == e->to ? to_itself(from) : between(from, to), 0, STEPS};
    while (s.first < STEPS && lies_in(at(&s.curve, (double)s.first / STEPS), from, 1))
        s.first++;
    while (s.last > s.first && lies_in(at(&s.curve, (double)s.last / STEPS), to, 1))
        s.last--;
    return s;
}

void deadlock_edge_draw(const struct canvas *c, const struct deadlock_layout *l,
                        const struct deadlock_edge *e)
{
    static const double DASHES[] = {5, 4};
    struct span s = span_of(l, e);
    canvas_colour(c, e->in_cycle ? INK : GREY);
    cairo_set_line_width(c->cr, e->in_cycle ? 3.2 : 1.1);
    cairo_set_dash(c->cr, DASHES, e->kind == WAITFOR_ANY_NODE ? 2 : 0, 0);
    draw_part(c, &s.curve, s.first, s.last, e->in_cycle ? 13 : 8);
    cairo_set_dash(c->cr, NULL, 0, 0);
}

/* --- labels --- */

static bool overlap(struct plot a, struct plot b)
{
    return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}

static bool is_free(const struct deadlock_graph *g, const struct deadlock_layout *l,
                    const struct deadlock_labels *labels, struct plot p)
{
    for (uint32_t k = 0; k < g->count; k++)
        if (overlap(p, l->places[k]))
            return false;
    for (uint32_t k = 0; k < labels->count; k++)
        if (overlap(p, labels->taken[k]))
            return false;
    return true;
}

static struct plot place_at(const struct span *s, const struct deadlock_edge *e, double part, double width)
{
    struct point m = at(&s->curve, (s->first + (s->last - s->first) * part) / STEPS);
    double x = m.x - width / 2 + (e->from == e->to ? width / 2 + 6 : 0);
    return (struct plot){x, m.y - 8, width, 16};
}

void deadlock_edge_label(const struct canvas *c, const struct deadlock_graph *g,
                         const struct deadlock_layout *l, const struct deadlock_edge *e, const char *text,
                         struct deadlock_labels *labels)
{
    static const double PARTS[] = {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8};
    enum { MOST = sizeof PARTS / sizeof *PARTS };
    struct text_style style = {11, INK, ANCHOR_MIDDLE, e->in_cycle};
    struct span s = span_of(l, e);
    double width = canvas_text_width(c, style, text) + 6;
    int i = 0;
    while (i < MOST && !is_free(g, l, labels, place_at(&s, e, PARTS[i], width)))
        i++;
    struct plot p = place_at(&s, e, PARTS[i % MOST], width);
    canvas_fill(c, p, COLOUR(0xffffff));
    canvas_text(c, p.x + p.w / 2, p.y + 12, style, text);
    labels->taken = xreallocarray(labels->taken, labels->count + 1, sizeof *labels->taken);
    labels->taken[labels->count++] = p;
}
