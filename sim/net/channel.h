/* channel.h - the channels of the network, and the contention for them.
 *
 * A transit takes the channels of its route in order, and holds all of them until its last byte has arrived
 * (circuit switching; a wormhole that is blocked holds its channels in the same way). A transit that finds a
 * channel taken waits for the channel, first come first served, and keeps those it has. Routes take channels
 * in an order without cycles (topo.h), so transits cannot deadlock. Taking a free channel takes no time; the
 * hops' time is part of the transit's duration.
 *
 * Where nodes are slower than channels, a message travels in packets, and packets of other messages go
 * between them. A transit of such a message holds the channels between nodes for as long as its bytes would
 * take at the channels' own speed (holds), and the two ports until it is done: several such messages share a
 * channel until their sum is more than the channel can carry.
 */
#ifndef NET_CHANNEL_H
#define NET_CHANNEL_H
#include "kernel/evq.h"
#include "net/topo.h"

struct channels; /* all of a machine */

struct channel_transit {
    /* set by the caller */
    uint32_t from, to; /* addresses (topo.h) */
    vtime duration;    /* from the whole route taken until the last byte has arrived */
    vtime holds; /* channels between nodes are given back after this time; 0: when the transit is done */
    /* set by channel.c */
    uint32_t first, last; /* of its channels so far, which are linked */
    /* while it waits for a channel */
    struct channel_transit *next; /* in the channel's queue */
    struct topo_walk walk;        /* so far */
};

/* What the channels call. */
struct channel_calls {
    void *ctx;
    void (*started)(void *ctx, struct channel_transit *t, vtime now); /* the whole route is taken */
    void (*done)(void *ctx, struct channel_transit *t, vtime now);    /* the last byte has arrived */
    /* The transit begins to wait for a channel, and has waited. Both NULL: nobody asks. */
    void (*blocked)(void *ctx, struct channel_transit *t, uint32_t channel, vtime now);
    void (*unblocked)(void *ctx, struct channel_transit *t, vtime now);
};

/* Does the transit give back the channels between nodes before it is done? */
static inline bool channel_gives_early(const struct channel_transit *t)
{
    return t->holds && t->holds < t->duration;
}

struct channels *channel_new(const struct topo *topo, struct evq *q, const struct channel_calls *calls);
void channel_free(struct channels *net);
/* Sets the calls `blocked` and `unblocked`. */
void channel_tell_blocks(struct channels *net, const struct channel_calls *calls);
/* The transit t must stay where it is until it is done. */
void channel_send(struct channels *net, struct channel_transit *t, vtime now);
/* Virtual time that transits have waited for channels, in sum, and how many transits did. Of a wait that has
 * not ended, the sum has the part before the latest event at any channel. */
vtime channel_waited(const struct channels *net);
uint64_t channel_waits(const struct channels *net);
#endif
