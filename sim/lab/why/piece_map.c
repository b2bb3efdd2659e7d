/* piece_map.c - see piece_map.h. */
#include "lab/why/piece_map.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

struct piece_map piece_map_new(const struct trace *t)
{
    return (struct piece_map){t, xcalloc((size_t)t->node_count, sizeof(struct trace_pieces))};
}

void piece_map_free(struct piece_map *m)
{
    for (int32_t i = 0; m->of && i < m->t->node_count; i++)
        free(m->of[i].list);
    free(m->of);
    m->of = NULL;
}

/* The pieces must fill the trace's time: all that follows relies on that. */
static void check(const struct trace *t, const struct trace_pieces *p)
{
    vtime at = t->from;
    for (size_t i = 0; i < p->count; i++) {
        assert(p->list[i].begin == at && p->list[i].end > at);
        at = p->list[i].end;
    }
    assert(at == t->to);
    (void)at;
}

const struct trace_pieces *piece_map_of(struct piece_map *m, int32_t node)
{
    struct trace_pieces *p = &m->of[node];
    assert(node >= 0 && node < m->t->node_count);
    if (!p->list && m->t->to > m->t->from) {
        trace_pieces(m->t, node, p);
        check(m->t, p);
    }
    return p;
}

const struct trace_piece *piece_map_from(struct piece_map *m, int32_t node, vtime t)
{
    const struct trace_pieces *p = piece_map_of(m, node);
    size_t low = 0, high = p->count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (p->list[middle].end > t)
            high = middle;
        else
            low = middle + 1;
    }
    return low < p->count ? &p->list[low] : NULL;
}

const struct trace_piece *piece_map_end(struct piece_map *m, int32_t node)
{
    const struct trace_pieces *p = piece_map_of(m, node);
    return p->list + p->count;
}

const struct trace_piece *piece_map_before(struct piece_map *m, int32_t node, vtime t)
{
    return t > m->t->from && t <= m->t->to ? piece_map_from(m, node, t - 1) : NULL;
}

/* The last of `count` rows, sorted by their beginnings, that begins before t, or at t; -1. A row has `size`
 * bytes, and its beginning `offset` bytes from its start. */
static int32_t last_begun(const void *rows, int32_t count, size_t size, size_t offset, vtime t, bool at_too)
{
    int32_t low = 0, high = count;
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        vtime begin = *(const vtime *)(const void *)((const char *)rows + (size_t)middle * size + offset);
        if (begin < t || (at_too && begin == t))
            low = middle + 1;
        else
            high = middle;
    }
    return low - 1;
}
#define LAST_BEGUN(rows, count, t, at_too)                                                                   \
    last_begun(rows, count, sizeof *(rows), (size_t)((const char *)&(rows)->begin - (const char *)(rows)),   \
               t, at_too)

int32_t piece_map_wait(const struct piece_map *m, const struct trace_piece *p, vtime t)
{
    if (p->wait != TRACE_NONE || p->call == TRACE_NONE)
        return p->wait;
    const struct trace_call *c = &m->t->calls[p->call];
    int32_t i = c->waits ? LAST_BEGUN(m->t->waits + c->first_wait, c->waits, t, false) : TRACE_NONE;
    return i >= 0 && m->t->waits[c->first_wait + i].end >= t ? c->first_wait + i : TRACE_NONE;
}

int32_t piece_map_handler(const struct piece_map *m, int32_t node, vtime t)
{
    const struct trace_node *n = &m->t->nodes[node];
    int32_t i =
        n->handlers ? LAST_BEGUN(m->t->handlers + n->first_handler, n->handlers, t, true) : TRACE_NONE;
    return i >= 0 && m->t->handlers[n->first_handler + i].begin == t ? n->first_handler + i : TRACE_NONE;
}

int32_t piece_map_system(const struct piece_map *m, int32_t node, enum trace_task task, vtime t)
{
    const struct trace_node *n = &m->t->nodes[node];
    int32_t i = n->systems ? LAST_BEGUN(m->t->systems + n->first_system, n->systems, t, false) : TRACE_NONE;
    /* Programmed I/O goes on while messages are handled. */
    for (int32_t tries = 0; i >= 0 && tries < 8; i--, tries++) {
        const struct trace_system *s = &m->t->systems[n->first_system + i];
        if (s->task == task && s->end >= t)
            return n->first_system + i;
    }
    return TRACE_NONE;
}
