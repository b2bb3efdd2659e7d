/* movers.c - see movers.h. */
#include "net/movers.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

struct mover {
    uint64_t moving;
    struct channel_transit *first, **end; /* of those that wait here; end: where the next one goes */
};

struct movers {
    uint64_t at_once;
    void (*start)(void *ctx, struct channel_transit *t, vtime now);
    void *ctx;
    struct mover mover[];
};

struct movers *movers_new(uint32_t addresses, uint64_t at_once,
                          void (*start)(void *ctx, struct channel_transit *t, vtime now), void *ctx)
{
    assert(at_once > 0);
    struct movers *m = xcalloc(1, sizeof *m + addresses * sizeof m->mover[0]);
    m->at_once = at_once, m->start = start, m->ctx = ctx;
    for (uint32_t i = 0; i < addresses; i++)
        m->mover[i].end = &m->mover[i].first;
    return m;
}

void movers_free(struct movers *m)
{
    free(m);
}

static bool is_full(const struct movers *m, uint32_t address)
{
    return m->mover[address].moving >= m->at_once;
}

static void queue(struct mover *at, struct channel_transit *t)
{
    t->next = NULL;
    *at->end = t, at->end = &t->next;
}

static struct channel_transit *unqueue(struct mover *at)
{
    struct channel_transit *t = at->first;
    at->first = t->next;
    if (!at->first)
        at->end = &at->first;
    return t;
}

void movers_ask(struct movers *m, struct channel_transit *t, vtime now)
{
    if (is_full(m, t->from) || is_full(m, t->to)) {
        queue(&m->mover[is_full(m, t->from) ? t->from : t->to], t);
        return;
    }
    m->mover[t->from].moving++;
    if (t->to != t->from) /* a message to itself is copied once */
        m->mover[t->to].moving++;
    m->start(m->ctx, t, now);
}

/* A place is free: of those that wait here, the ones that can start do, and the others wait at their other
 * end. */
static void serve(struct movers *m, uint32_t address, vtime now)
{
    while (m->mover[address].first && !is_full(m, address))
        movers_ask(m, unqueue(&m->mover[address]), now);
}

void movers_done(struct movers *m, const struct channel_transit *t, vtime now)
{
    uint32_t from = t->from, to = t->to;
    assert(m->mover[from].moving > 0 && m->mover[to].moving > 0);
    m->mover[from].moving--;
    if (to != from)
        m->mover[to].moving--;
    serve(m, from, now);
    serve(m, to, now);
}
