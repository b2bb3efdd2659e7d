/* race_clock.c - see race_clock.h. */
#include "races/race_clock.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

struct race_clock {
    uint32_t users; /* atomic */
    uint32_t nodes; /* of those from here on it has heard of nothing */
    struct race_known known[];
};

struct race_clock *race_clock_share(struct race_clock *c)
{
    if (c)
        __atomic_fetch_add(&c->users, 1, __ATOMIC_RELAXED);
    return c;
}

void race_clock_free(struct race_clock *c)
{
    if (c && __atomic_fetch_sub(&c->users, 1, __ATOMIC_ACQ_REL) == 1)
        free(c);
}

struct race_known race_clock_of(const struct race_clock *c, uint32_t node)
{
    return c && node < c->nodes ? c->known[node] : (struct race_known){0, 0};
}

/* *c with room for so many nodes, and nobody else's. */
static struct race_clock *own(struct race_clock **c, uint32_t nodes)
{
    struct race_clock *old = *c;
    if (old && old->nodes >= nodes && __atomic_load_n(&old->users, __ATOMIC_ACQUIRE) == 1)
        return old;
    nodes = old && old->nodes > nodes ? old->nodes : nodes;
    struct race_clock *new = xcalloc(1, sizeof *new + nodes * sizeof *new->known);
    new->users = 1, new->nodes = nodes;
    if (old)
        memcpy(new->known, old->known, old->nodes * sizeof *old->known);
    race_clock_free(old);
    return *c = new;
}

static bool covers(struct race_known a, struct race_known b)
{
    return a.main >= b.main && a.handlers >= b.handlers;
}

static void hear(struct race_known *k, struct race_known other)
{
    k->main = other.main > k->main ? other.main : k->main;
    k->handlers = other.handlers > k->handlers ? other.handlers : k->handlers;
}

bool race_clock_includes(const struct race_clock *a, const struct race_clock *b)
{
    if (a == b || !b)
        return true;
    for (uint32_t i = 0; i < b->nodes; i++)
        if (!covers(race_clock_of(a, i), b->known[i]))
            return false;
    return true;
}

void race_clock_join(struct race_clock **c, const struct race_clock *other)
{
    if (race_clock_includes(*c, other))
        return;
    struct race_clock *new = own(c, other->nodes);
    for (uint32_t i = 0; i < other->nodes; i++)
        hear(&new->known[i], other->known[i]);
}

void race_clock_hear(struct race_clock **c, uint32_t node, struct race_known known)
{
    if (!covers(race_clock_of(*c, node), known))
        hear(&own(c, node + 1)->known[node], known);
}
