/* deadlock_graph.c - see deadlock_graph.h. */
#include "lab/deadlock/deadlock_graph.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

enum { CYCLE_BEGIN = 4, CYCLE_END = 3, MOST_OTHERS = DEADLOCK_MOST_BOXES - DEADLOCK_MOST_CYCLE };

/* --- boxes --- */

static struct deadlock_box *new_box(struct deadlock_graph *g)
{
    g->boxes = xreallocarray(g->boxes, g->count + 1, sizeof *g->boxes);
    g->boxes[g->count] = (struct deadlock_box){0};
    return &g->boxes[g->count++];
}

static int by_number(const void *a, const void *b)
{
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

static void put(const struct deadlock_graph *g, struct deadlock_box *b, uint32_t node)
{
    if (!b->count)
        b->like = &g->w->nodes[node];
    b->nodes = xreallocarray(b->nodes, b->count + 1, sizeof *b->nodes);
    b->nodes[b->count++] = node;
}

static void add_cycle(struct deadlock_graph *g)
{
    const struct waitfor *w = g->w;
    bool is_long = w->cycle_count > DEADLOCK_MOST_CYCLE;
    for (uint32_t k = 0; k < w->cycle_count; k++) {
        bool between = is_long && k > CYCLE_BEGIN && k < w->cycle_count - CYCLE_END;
        struct deadlock_box *b = between ? &g->boxes[g->count - 1] : new_box(g);
        put(g, b, w->cycle[k]);
        b->in_cycle = true;
    }
    g->cycle_count = g->count;
    for (uint32_t i = 0; i < g->count; i++)
        qsort(g->boxes[i].nodes, g->boxes[i].count, sizeof *g->boxes[i].nodes, by_number);
}

static bool is_same_text(const char *a, const char *b)
{
    return a && b ? strcmp(a, b) == 0 : a == b;
}

static bool is_alike(const struct waitfor_node *a, const struct waitfor_node *b)
{
    if (a->state != b->state || a->exit_status != b->exit_status || a->is_host || b->is_host ||
        !is_same_text(a->line, b->line))
        return false;
    if (a->state != WAITFOR_WAITS)
        return true;
    return is_same_text(a->call, b->call) && a->has_type == b->has_type && a->type == b->type &&
           a->what == b->what && a->select.typesel == b->select.typesel && a->who == b->who &&
           a->cause == b->cause && is_same_text(a->operation, b->operation);
}

static void add_others(struct deadlock_graph *g)
{
    bool alone = g->w->count <= DEADLOCK_MOST_ALONE;
    for (uint32_t i = 0; i < g->w->count; i++) {
        const struct waitfor_node *n = &g->w->nodes[i];
        uint32_t k = alone ? g->count : g->cycle_count;
        if (n->in_cycle)
            continue;
        while (k < g->count && !is_alike(g->boxes[k].like, n))
            k++;
        put(g, k < g->count ? &g->boxes[k] : new_box(g), i);
    }
}

static int larger_first(const void *a, const void *b)
{
    const struct deadlock_box *x = a, *y = b;
    if (x->count != y->count)
        return x->count < y->count ? 1 : -1;
    return by_number(&x->nodes[0], &y->nodes[0]);
}

/* The smallest of too many boxes become one. */
static void join_smallest(struct deadlock_graph *g)
{
    struct deadlock_box *others = g->boxes + g->cycle_count;
    uint32_t count = g->count - g->cycle_count;
    if (g->w->count > DEADLOCK_MOST_ALONE)
        qsort(others, count, sizeof *others, larger_first);
    if (count <= MOST_OTHERS)
        return;
    struct deadlock_box *last = &others[MOST_OTHERS - 1];
    last->mixed = true;
    for (uint32_t k = MOST_OTHERS; k < count; k++) {
        for (uint32_t i = 0; i < others[k].count; i++)
            put(g, last, others[k].nodes[i]);
        free(others[k].nodes);
    }
    qsort(last->nodes, last->count, sizeof *last->nodes, by_number);
    g->count = g->cycle_count + MOST_OTHERS;
}

/* --- edges --- */

static void add_edge(struct deadlock_graph *g, uint32_t from, uint32_t to, enum waitfor_who kind)
{
    for (uint32_t i = 0; i < g->edge_count; i++)
        if (g->edges[i].from == from && g->edges[i].to == to)
            return;
    bool next = from < g->cycle_count && to == (from + 1) % g->cycle_count;
    g->edges = xreallocarray(g->edges, g->edge_count + 1, sizeof *g->edges);
    g->edges[g->edge_count++] = (struct deadlock_edge){from, to, kind, next};
}

static uint32_t *boxes_of_nodes(const struct deadlock_graph *g)
{
    uint32_t *box = xcalloc(g->w->count, sizeof *box);
    for (uint32_t k = 0; k < g->count; k++)
        for (uint32_t i = 0; i < g->boxes[k].count; i++)
            box[g->boxes[k].nodes[i]] = k;
    return box;
}

static bool needs_any_of(const struct deadlock_graph *g, uint32_t node, const struct deadlock_box *b)
{
    uint32_t i = 0;
    while (i < b->count && !waitfor_needs(g->w, node, b->nodes[i]))
        i++;
    return i < b->count;
}

/* Nodes that wait for any, or for all of several, wait for the same boxes as others of their box. */
static void add_edges(struct deadlock_graph *g, uint32_t k, const uint32_t *box)
{
    const struct deadlock_box *b = &g->boxes[k];
    enum waitfor_who who = b->like->who;
    for (uint32_t i = 0; i < b->count; i++) {
        const struct waitfor_node *n = &g->w->nodes[b->nodes[i]];
        if (n->state == WAITFOR_WAITS && n->who == WAITFOR_ONE_NODE &&
            (b->count == 1 || !b->in_cycle || box[n->whom] != k))
            add_edge(g, k, box[n->whom], WAITFOR_ONE_NODE);
    }
    if (b->mixed || b->like->state != WAITFOR_WAITS || (who != WAITFOR_ANY_NODE && who != WAITFOR_ALL_NODES))
        return;
    for (uint32_t to = 0; to < g->count; to++)
        if (needs_any_of(g, b->nodes[0], &g->boxes[to]))
            add_edge(g, k, to, who);
}

struct deadlock_graph *deadlock_graph_make(const struct waitfor *w)
{
    struct deadlock_graph *g = xcalloc(1, sizeof *g);
    g->w = w;
    add_cycle(g);
    add_others(g);
    join_smallest(g);
    uint32_t *box = boxes_of_nodes(g);
    for (uint32_t k = 0; k < g->count; k++)
        add_edges(g, k, box);
    free(box);
    return g;
}

void deadlock_graph_free(struct deadlock_graph *g)
{
    for (uint32_t k = 0; k < g->count; k++)
        free(g->boxes[k].nodes);
    free(g->boxes);
    free(g->edges);
    free(g);
}
