/* wire.c - see wire.h. */
#include "net/wire.h"
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

static void wait(struct wire *w, struct channel *c, struct wire_transit *t, vtime now)
{
    w->waits++, w->waiting++;
    w->waited -= now;
    w->latest = now;
    queue(c, t);
}

/* Does it give back channels between nodes before it is done? */
static bool gives_early(const struct wire_transit *t)
{
    return t->holds && t->holds < t->duration;
}

static void pass(void *ctx, void *arg, vtime now);
static void finish(void *ctx, void *arg, vtime now);

/* Notes the next channel of the route. */
static struct channel *note(struct wire *w, struct wire_transit *t, uint32_t channel, bool is_first)
{
    struct channel *c = &w->channels[channel];
    if (is_first)
        t->first = channel;
    else
        w->channels[t->last].next = channel;
    t->last = channel;
    return c;
}

/* Takes channels from there on until the route is complete, or one is another's. */
static void advance(struct wire *w, struct wire_transit *t, struct topo_walk walk, vtime now)
{
    bool is_first = !walk.entered;
    for (uint32_t channel; topo_step(&w->topo, &walk, &channel); is_first = false) {
        struct channel *c = note(w, t, channel, is_first);
        if (c->held) {
            t->walk = walk;
            wait(w, c, t, now);
            return;
        }
        c->held = true;
    }
    if (gives_early(t))
        evq_put(w->q, now + t->holds, t->to, pass, w, t);
    evq_put(w->q, now + t->duration, t->to, finish, w, t);
    w->calls.started(w->calls.ctx, t, now);
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
    struct wire_transit *t = unqueue(c);
    advance(w, t, t->walk, now);
}

/* Give back the channels between nodes, in order, from the one after the port in. */
static void give_links(struct wire *w, const struct wire_transit *t, uint32_t from, vtime now)
{
    const struct channel *end = &w->channels[t->last];
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
    give_links(w, t, w->channels[t->first].next, now);
}

static void finish(void *ctx, void *arg, vtime now)
{
    struct wire *w = ctx;
    struct wire_transit *t = arg;
    uint32_t inner = w->channels[t->first].next;
    hand_over(w, &w->channels[t->first], now);
    if (!gives_early(t))
        give_links(w, t, inner, now);
    hand_over(w, &w->channels[t->last], now);
    w->calls.done(w->calls.ctx, t, now);
}

void wire_send(struct wire *w, struct wire_transit *t, vtime now)
{
    struct topo_walk walk;
    topo_begin(&w->topo, &walk, t->from, t->to);
    advance(w, t, walk, now);
}

vtime wire_waited(const struct wire *w)
{
    return w->waited + w->waiting * w->latest;
}

uint64_t wire_waits(const struct wire *w)
{
    return w->waits;
}
