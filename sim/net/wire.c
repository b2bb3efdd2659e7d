/* wire.c - see wire.h. */
#include "net/wire.h"
#include <stdlib.h>

struct channel {
    struct wire_transit *holder;
    struct wire_transit *first, *last; /* waiting */
    uint32_t next;                     /* the holder's channel after this one, if it has come so far */
};

struct wire {
    struct topo topo;
    struct evq *q;
    struct wire_calls calls;
    struct channel *channels;
    vtime waited; /* in all, less the beginnings of waits that have no end yet */
    vtime latest; /* when a channel was last asked for or given back */
    uint64_t waits, waiting;
};

struct wire *wire_new(const struct topo *topo, struct evq *q, const struct wire_calls *calls)
{
    struct wire *w = calloc(1, sizeof *w);
    if (!w)
        return NULL;
    w->topo = *topo, w->q = q, w->calls = *calls;
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

static void join(struct wire *w, struct wire_transit *t, uint32_t channel)
{
    if (t->held++ == 0)
        t->first = channel;
    else
        w->channels[t->latest].next = channel;
    t->latest = channel;
}

/* Take channels until the route is complete or one is taken by another. */
static void advance(struct wire *w, struct wire_transit *t, vtime now)
{
    uint32_t channel;
    while (topo_step(&w->topo, &t->walk, &channel)) {
        struct channel *c = &w->channels[channel];
        join(w, t, channel);
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
    w->calls.started(t, now);
}

/* Give a channel to the first that waits for it, which goes on. */
static void hand_over(struct wire *w, struct channel *c, vtime now)
{
    struct wire_transit *t = c->first;
    c->holder = t;
    if (!t)
        return;
    c->first = t->next;
    if (!c->first)
        c->last = NULL;
    w->waiting--;
    w->waited += now;
    w->latest = now;
    advance(w, t, now);
}

/* Give back the channels between nodes, in order, from the one after the port in. */
static void give_links(struct wire *w, const struct wire_transit *t, uint32_t from, vtime now)
{
    for (uint32_t i = from, next; i != t->latest; i = next) {
        next = w->channels[i].next;
        hand_over(w, &w->channels[i], now);
    }
}

static void pass(void *ctx, void *arg, vtime now)
{
    struct wire *w = ctx;
    struct wire_transit *t = arg;
    t->passed = true;
    give_links(w, t, w->channels[t->first].next, now);
}

static void finish(void *ctx, void *arg, vtime now)
{
    struct wire *w = ctx;
    struct wire_transit *t = arg;
    uint32_t inner = w->channels[t->first].next;
    hand_over(w, &w->channels[t->first], now);
    if (!t->passed)
        give_links(w, t, inner, now);
    hand_over(w, &w->channels[t->latest], now);
    w->calls.done(t, now);
}

void wire_send(struct wire *w, struct wire_transit *t, vtime now)
{
    t->held = 0;
    t->passed = false;
    topo_begin(&w->topo, &t->walk, t->from, t->to);
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
