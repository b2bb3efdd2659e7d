/* wire.c - see wire.h. */
#include "net/wire.h"
#include <stddef.h>
#include <stdlib.h>

struct channel {
    struct wire_transit *last; /* of those that wait, which are a ring: its next is the first. NULL: none */
    uint32_t next;             /* the holder's channel after this one, if it has come so far */
    bool held;
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
    t->next = t;
    if (c->last)
        t->next = c->last->next, c->last->next = t;
    c->last = t;
}

/* The first that waits; there is one. */
static struct wire_transit *unqueue(struct channel *c)
{
    struct wire_transit *first = c->last->next;
    c->last->next = first->next;
    if (c->last == first)
        c->last = NULL;
    return first;
}

static void pass(void *ctx, void *arg, vtime now);
static void finish(void *ctx, void *arg, vtime now);

/* Takes channels until the route is complete, or one is another's: then it returns that. */
static struct channel *take(struct wire *w, struct wire_transit *t)
{
    struct topo_walk walk = t->walk;
    struct channel *taken = NULL;
    uint32_t *link = t->link;
    for (uint32_t channel; !taken && topo_step(&w->topo, &walk, &channel);) {
        struct channel *c = &w->channels[channel];
        *link = channel;
        link = &c->next;
        if (c->held)
            taken = c;
        c->held = true;
    }
    t->walk = walk;
    t->link = link;
    return taken;
}

static void advance(struct wire *w, struct wire_transit *t, vtime now)
{
    struct channel *taken = take(w, t);
    if (taken) {
        w->waits++, w->waiting++;
        w->waited -= now;
        w->latest = now;
        queue(taken, t);
        return;
    }
    if (t->holds && t->holds < t->duration)
        evq_put(w->q, now + t->holds, t->to, pass, w, t);
    evq_put(w->q, now + t->duration, t->to, finish, w, t);
    w->calls.started(t, now);
}

/* Give a channel to the first that waits for it, which goes on. */
static void hand_over(struct wire *w, struct channel *c, vtime now)
{
    c->held = c->last;
    if (!c->held)
        return;
    w->waiting--;
    w->waited += now;
    w->latest = now;
    advance(w, unqueue(c), now);
}

/* The last of the route, which is complete. */
static struct channel *latest(const struct wire_transit *t)
{
    return (struct channel *)((char *)t->link - offsetof(struct channel, next));
}

/* Give back the channels between nodes, in order, from the one after the port in. */
static void give_links(struct wire *w, const struct wire_transit *t, uint32_t from, vtime now)
{
    const struct channel *end = latest(t);
    for (struct channel *c = &w->channels[from]; c != end;) {
        uint32_t next = c->next;
        hand_over(w, c, now);
        c = &w->channels[next];
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
    hand_over(w, latest(t), now);
    w->calls.done(t, now);
}

void wire_send(struct wire *w, struct wire_transit *t, vtime now)
{
    t->link = &t->first;
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
