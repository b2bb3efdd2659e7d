/* wire.c - see wire.h. */
#include "net/wire.h"
#include <stdlib.h>

struct channel {
    struct wire_transit *holder;
    struct wire_transit *first, *last; /* waiting */
};

struct wire {
    struct topo topo;
    struct evq *q;
    struct channel *channels;
    vtime waited; /* in all, less the beginnings of waits that have no end yet */
    vtime latest; /* when a channel was last asked for or given back */
    uint64_t waits, waiting;
};

struct wire *wire_new(const struct topo *topo, struct evq *q)
{
    struct wire *w = calloc(1, sizeof *w);
    if (!w)
        return NULL;
    w->topo = *topo, w->q = q;
    w->channels = calloc(topo->channels, sizeof *w->channels);
    if (!w->channels) {
        free(w);
        return NULL;
    }
    return w;
}

void wire_free(struct wire *w)
{
    if (!w)
        return;
    free(w->channels);
    free(w);
}

static void queue(struct channel *c, struct wire_transit *t)
{
    t->next = NULL;
    if (c->last)
        c->last->next = t;
    else
        c->first = t;
    c->last = t;
}

static void pass(void *ctx, void *arg, vtime now);
static void finish(void *ctx, void *arg, vtime now);

/* Take channels until the route is complete or one is taken by another. */
static void advance(struct wire *w, struct wire_transit *t, vtime now)
{
    uint32_t channel;
    while (topo_step(&w->topo, &t->walk, &channel)) {
        struct channel *c = &w->channels[channel];
        t->held++;
        if (c->holder) {
            w->waits++, w->waiting++;
            w->waited -= now;
            w->latest = now;
            queue(c, t);
            return;
        }
        c->holder = t;
    }
    if (t->holds && t->holds < t->duration)
        evq_put(w->q, now + t->holds, t->to, pass, w, t);
    evq_put(w->q, now + t->duration, t->to, finish, w, t);
    t->started(t->ctx, t, now);
}

/* Give a channel to the first that waits for it: it may go on. NULL: nobody waits. */
static struct wire_transit *hand_over(struct wire *w, struct channel *c, vtime now)
{
    struct wire_transit *t = c->first;
    c->holder = t;
    if (!t)
        return NULL;
    c->first = t->next;
    if (!c->first)
        c->last = NULL;
    w->waiting--;
    w->waited += now;
    w->latest = now;
    return t;
}

/* Give back the channels between nodes, the two ports, or both: a route's first and last channels are the ports. */
static void give_back(struct wire *w, const struct wire_transit *t, bool links, bool ports, vtime now)
{
    struct topo_walk walk;
    uint32_t channel;
    topo_begin(&walk, t->from, t->to);
    for (uint32_t i = 0; i < t->held && topo_step(&w->topo, &walk, &channel); i++) {
        bool port = i == 0 || i == t->held - 1;
        if (port ? !ports : !links)
            continue;
        struct wire_transit *heir = hand_over(w, &w->channels[channel], now);
        if (heir)
            advance(w, heir, now);
    }
}

static void pass(void *ctx, void *arg, vtime now)
{
    struct wire_transit *t = arg;
    t->passed = true;
    give_back(ctx, t, true, false, now);
}

static void finish(void *ctx, void *arg, vtime now)
{
    struct wire_transit *t = arg;
    give_back(ctx, t, !t->passed, true, now);
    t->done(t->ctx, t, now);
}

void wire_send(struct wire *w, struct wire_transit *t, vtime now)
{
    t->held = 0;
    t->passed = false;
    topo_begin(&t->walk, t->from, t->to);
    advance(w, t, now);
}

vtime wire_waited(const struct wire *w)
{
    return w->waited + w->waiting * w->latest;
}

uint64_t wire_waits(const struct wire *w)
{
    return w->waits;
}
