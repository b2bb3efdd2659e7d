/* modes.c - see modes.h. */
#include "cfs/modes.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

void modes_free(struct modes *m)
{
    free(m->group[MODE_RECORDS].rounds);
}

void modes_join(struct modes *m, int mode, uint64_t at)
{
    struct modes_group *g = &m->group[mode];
    if (g->members++ > 0)
        return;
    g->generation++;
    g->at = at;
    g->turn = 0;
    g->round_count = 0;
}

void modes_leave(struct modes *m, int mode)
{
    assert(m->group[mode].members > 0);
    m->group[mode].members--;
}

uint64_t modes_take(struct modes_group *g, uint64_t bytes)
{
    uint64_t at = g->at;
    g->at += bytes;
    return at;
}

void modes_next_turn(struct modes_group *g, uint32_t nodes)
{
    g->turn = (g->turn + 1) % nodes;
}

/* Where a round starts that no node has moved. */
static uint64_t from(const struct modes_group *g, uint64_t round, uint32_t nodes)
{
    const struct modes_round *last = round ? &g->rounds[round - 1] : NULL;
    return last ? last->start + last->bytes * nodes : g->at;
}

/* The round of that number. Rounds are reached one after the other, and made when they are. */
static struct modes_round *the_round(struct modes_group *g, uint64_t round, uint32_t nodes)
{
    while (g->round_count <= round) {
        if ((g->round_count & (g->round_count + 1)) == 0)
            g->rounds = xreallocarray(g->rounds, 2 * g->round_count + 1, sizeof *g->rounds);
        g->rounds[g->round_count] = (struct modes_round){.start = from(g, g->round_count, nodes)};
        g->round_count++;
    }
    return &g->rounds[round];
}

struct modes_round modes_record(struct modes_group *g, uint64_t round, uint32_t nodes, const uint64_t *sought,
                                uint64_t bytes)
{
    struct modes_round *r = the_round(g, round, nodes);
    if (!r->begun)
        *r = (struct modes_round){sought ? *sought : r->start, bytes, true};
    return *r;
}

uint64_t modes_round_from(struct modes_group *g, uint64_t round, uint32_t nodes)
{
    the_round(g, round, nodes);
    return from(g, round, nodes);
}

void modes_set_round(struct modes_group *g, uint64_t round, uint32_t nodes, uint64_t start)
{
    struct modes_round *r = the_round(g, round, nodes);
    if (!r->begun)
        r->start = start;
}
