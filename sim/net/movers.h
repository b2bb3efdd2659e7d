/* movers.h - processors that move bytes by programmed I/O, and may move only so many messages at once.
 *
 * Where a machine file says `moves_at_once`, the data of a message longer than short_limit enter the network
 * when the processors at both ends have a place free; they keep both places until the last byte has arrived.
 * With 1, the two directions of an exchange take turns. A trip that finds no place waits at the end that has
 * none, first come first served; a trip whose other end is taken meanwhile waits there, behind the others. No
 * trip holds a place while it waits for one, and all have theirs before they take channels: so that there is
 * no deadlock.
 */
#ifndef NET_MOVERS_H
#define NET_MOVERS_H
#include "net/channel.h"

struct movers;

/* start() is called when a transit has its places, by movers_ask() itself or by a later movers_done(). */
struct movers *movers_new(uint32_t addresses, uint64_t at_once,
                          void (*start)(void *ctx, struct channel_transit *t, vtime now), void *ctx);
void movers_free(struct movers *m);
/* A transit wants a place at both ends. It must stay where it is; its `next` is used. */
void movers_ask(struct movers *m, struct channel_transit *t, vtime now);
/* A transit gives its places back. */
void movers_done(struct movers *m, const struct channel_transit *t, vtime now);
#endif
