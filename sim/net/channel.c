/* channel.c - see channel.h. */
#include "net/channel.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

struct channel {
    struct channel_transit
        *last;     /* of the waiting ones, which are a ring: its next is the first. NULL: none waits */
    uint32_t next; /* the channel after this one of the transit that holds it, if it has come so far */
    bool held;
};

struct channels {
    struct topo topo;
    struct evq *q;
    struct channel_calls calls;
    struct channel *channels;
    vtime waited; /* in all, less the beginnings of waits that have no end yet */
    vtime latest; /* when a transit last began or ended to wait */
    uint64_t waits, waiting;
};

struct channels *channel_new(const struct topo *topo, struct evq *q, const struct channel_calls *calls)
{
    struct channels *net = xcalloc(1, sizeof *net);
    net->topo = *topo, net->q = q, net->calls = *calls;
    net->channels = xcalloc(topo->channels, sizeof *net->channels);
    return net;
}

void channel_free(struct channels *net)
{
    if (!net)
        return;
    free(net->channels);
    free(net);
}

void channel_tell_blocks(struct channels *net, const struct channel_calls *calls)
{
    net->calls.blocked = calls->blocked, net->calls.unblocked = calls->unblocked;
}

static void queue(struct channel *c, struct channel_transit *t)
{
    t->next = t;
    if (c->last)
        t->next = c->last->next, c->last->next = t;
    c->last = t;
}

/* Takes the first of the waiting transits off the queue; there must be one. */
static struct channel_transit *unqueue(struct channel *c)
{
    struct channel_transit *first = c->last->next;
    c->last->next = first->next;
    if (c->last == first)
        c->last = NULL;
    return first;
}

static void begin_wait(struct channels *net, struct channel *c, struct channel_transit *t, vtime now)
{
    assert(now >= net->latest);
    net->waits++, net->waiting++;
    net->waited -= now;
    net->latest = now;
    queue(c, t);
    if (net->calls.blocked)
        net->calls.blocked(net->calls.ctx, t, (uint32_t)(c - net->channels), now);
}

static struct channel_transit *end_wait(struct channels *net, struct channel *c, vtime now)
{
    assert(net->waiting > 0 && now >= net->latest);
    net->waiting--;
    net->waited += now;
    net->latest = now;
    struct channel_transit *t = unqueue(c);
    if (net->calls.unblocked)
        net->calls.unblocked(net->calls.ctx, t, now);
    return t;
}

static void give_links_early(void *ctx, void *arg, vtime now);
static void finish(void *ctx, void *arg, vtime now);

/* Takes channels from there on until the route is complete, or a channel is another's. */
static void advance(struct channels *net, struct channel_transit *t, struct topo_walk *walk, vtime now)
{
    struct channel *channels = net->channels;
    uint32_t *link = walk->entered ? &channels[t->last].next : &t->first;
    for (uint32_t channel; topo_step(&net->topo, walk, &channel);) {
        struct channel *c = &channels[channel];
        *link = t->last = channel;
        link = &c->next;
        if (c->held) {
            t->walk = *walk;
            begin_wait(net, c, t, now);
            return;
        }
        c->held = true;
    }
    if (channel_gives_early(t))
        evq_put(net->q, now + t->holds, t->to, give_links_early, net, t);
    evq_put(net->q, now + t->duration, t->to, finish, net, t);
    net->calls.started(net->calls.ctx, t, now);
}

/* Gives a channel to the first transit that waits for it, which goes on along its route. */
static __attribute__((noinline)) void pass_on(struct channels *net, struct channel *c, vtime now)
{
    struct channel_transit *next = end_wait(net, c, now);
    advance(net, next, &next->walk, now);
}

static inline void give(struct channels *net, struct channel *c, vtime now)
{
    assert(c->held);
    c->held = c->last;
    if (c->last)
        pass_on(net, c, now);
}

/* Gives back the channels between nodes, in order, from the one after the port in. */
static void give_links(struct channels *net, const struct channel_transit *t, uint32_t from, vtime now)
{
    struct channel *channels = net->channels;
    for (uint32_t i = from, end = t->last; i != end;) {
        struct channel *c = &channels[i];
        i = c->next;
        give(net, c, now);
    }
}

static void give_links_early(void *ctx, void *arg, vtime now)
{
    struct channels *net = ctx;
    struct channel_transit *t = arg;
    give_links(net, t, net->channels[t->first].next, now);
}

static void finish(void *ctx, void *arg, vtime now)
{
    struct channels *net = ctx;
    struct channel_transit *t = arg;
    uint32_t inner = net->channels[t->first].next;
    give(net, &net->channels[t->first], now);
    if (!channel_gives_early(t))
        give_links(net, t, inner, now);
    give(net, &net->channels[t->last], now);
    net->calls.done(net->calls.ctx, t, now);
}

void channel_send(struct channels *net, struct channel_transit *t, vtime now)
{
    struct topo_walk walk;
    topo_begin(&net->topo, &walk, t->from, t->to);
    advance(net, t, &walk, now);
}

vtime channel_waited(const struct channels *net)
{
    return net->waited + net->waiting * net->latest;
}

uint64_t channel_waits(const struct channels *net)
{
    return net->waits;
}
