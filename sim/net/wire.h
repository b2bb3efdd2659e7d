/* wire.h - channels and their contention.
 *
 * A transit takes the channels of its route in order, and holds them all until its last byte is through
 * (circuit switching; a wormhole that is blocked holds what it has in the same way). One that finds a channel
 * taken waits for it, first come first served, keeping those it has. Routes take channels in an order without
 * cycles (topo.h), so this cannot deadlock. Taking a free channel takes no time; the hops' time is part of
 * the transit's duration.
 *
 * Where nodes are slower than channels, a message travels in packets, and those of others go between them. Its transit
 * holds its channels for as long as its bytes would take at the channels' own speed (holds), and the two ports until
 * it is done: several such messages share a channel until their sum is more than it can carry.
 */
#ifndef WIRE_WIRE_H
#define WIRE_WIRE_H
#include "kernel/evq.h"
#include "net/topo.h"

struct wire;

struct wire_transit {
    /* set by the caller */
    uint32_t from, to;
    vtime duration; /* from the whole route taken until the last byte has arrived */
    vtime holds;    /* channels between nodes are given back after this time; 0: when it is done */
    /* the wire's own */
    uint32_t first, last; /* of its channels so far, which are linked */
    /* while it waits */
    struct wire_transit *next; /* in a channel's queue */
    struct topo_walk walk;     /* so far */
};

/* What the wire tells. */
struct wire_calls {
    void *ctx;
    void (*started)(void *ctx, struct wire_transit *t, vtime now); /* the whole route is taken */
    void (*done)(void *ctx, struct wire_transit *t, vtime now);    /* the last byte has arrived */
};

struct wire *wire_new(const struct topo *topo, struct evq *q, const struct wire_calls *calls);
void wire_free(struct wire *w);
/* t must stay where it is until it is done. */
void wire_send(struct wire *w, struct wire_transit *t, vtime now);
/* Virtual time transits have waited for channels, in sum, and how many did. Of a wait that has not ended counts what was
 * before the latest event at any channel. */
vtime wire_waited(const struct wire *w);
uint64_t wire_waits(const struct wire *w);
#endif
