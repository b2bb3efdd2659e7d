/* protocol_trip.c - a trip of a message, or of its data, through the channels: the sender's processor hands
 * it over, the receiver's takes it out. */
#include <stddef.h>
#include "net/protocol_parts.h"

static struct trip *trip_of(struct channel_transit *t)
{
    return (struct trip *)((char *)t - offsetof(struct trip, transit));
}

static void sent(struct protocol *p, struct trip *t, vtime now)
{
    protocol_unlink_out(t);
    if (t->followed && t->m->followed)
        endpoint_sent(p->ends, t->m, now);
}

/* The sender's processor moves the message into the channel. */
static void pio_send(struct protocol *p, const struct trip *t, vtime now)
{
    vtime takes = t->m->bytes * p->cfg->send_ps_per_byte;
    endpoint_pio(p->ends, t->transit.from, PROTOCOL_SEND, now, takes);
}

/* The message, or its data, enter the network, and the sender's processor is free to move them. */
static void enter(struct protocol *p, struct trip *t, vtime now)
{
    if (t->kind != TRIP_SHORT)
        pio_send(p, t, now);
    vtime duration = t->transit.duration;
    /* Once the message has left, a handler of the sender may be due. The message may have to wait for
     * channels first. */
    t->at_sender = (struct protocol_bound){.at = now + duration, .after = duration};
    t->at_receiver = protocol_after(t->kind != TRIP_SHORT ? protocol_latency(p, t->m) : duration);
    if (t->kind != TRIP_LONG)
        sent(p, t, now); /* the operating system has a copy: the caller's buffer is free */
    channel_send(p->channels, &t->transit, now);
}

void protocol_places_found(void *ctx, struct channel_transit *transit, vtime now)
{
    enter(ctx, trip_of(transit), now);
}

/* The message, or its data, are to enter the network. */
void protocol_inject(void *ctx, void *arg, vtime now)
{
    struct protocol *p = ctx;
    struct trip *t = arg;
    if (t->taken_back) {
        protocol_message_free(t->m);
        return;
    }
    protocol_note(p, t, MESSAGE_ENTERED, now);
    if (t->kind != TRIP_SHORT && p->movers) {
        t->at_sender = protocol_after(0); /* the sender's processor begins to move bytes at some event */
        t->at_receiver = protocol_after(protocol_latency(p, t->m));
        movers_ask(p->movers, &t->transit, now);
    } else {
        enter(p, t, now);
    }
}

/* The first byte has come: the receiver's processor moves the message out of the channel. */
static void pio_receive(void *ctx, void *arg, vtime now)
{
    struct protocol *p = ctx;
    struct message *m = arg;
    endpoint_pio(p->ends, m->to, PROTOCOL_RECEIVE, now, m->bytes * p->cfg->receive_ps_per_byte);
    m->trip->at_receiver = protocol_at(now + m->bytes * p->cfg->long_ps_per_byte);
}

/* Does the tail come with the first byte, since the network takes no time for bytes? The event of the
 * tail's passing is the earlier one then, and the only one. */
static bool comes_at_once(const struct protocol *p, const struct trip *t)
{
    return t->transit.duration == protocol_latency(p, t->m);
}

inline void protocol_trip_started(void *ctx, struct channel_transit *transit, vtime now)
{
    struct protocol *p = ctx;
    struct trip *t = trip_of(transit);
    protocol_note(p, t, MESSAGE_MOVED, now);
    if (channel_gives_early(transit))
        protocol_note(p, t, MESSAGE_FREED, now + transit->holds);
    t->at_sender = protocol_at(now + transit->duration);
    if (t->kind == TRIP_SHORT) {
        t->at_receiver = protocol_at(now + transit->duration);
        return;
    }
    vtime first_byte = now + protocol_latency(p, t->m);
    t->at_receiver = protocol_at(first_byte);
    if (!comes_at_once(p, t))
        evq_put(p->q, first_byte, transit->to, pio_receive, p, t->m);
}

/* A trip whose bytes the processors move has ended. */
static void bytes_moved(struct protocol *p, struct trip *t, vtime now)
{
    if (t->m->bytes && comes_at_once(p, t))
        pio_receive(p, t->m, now);
    if (t->kind == TRIP_LONG)
        sent(p, t, now);
    if (p->movers)
        movers_done(p->movers, &t->transit, now);
}

inline void protocol_trip_done(void *ctx, struct channel_transit *transit, vtime now)
{
    struct protocol *p = ctx;
    struct trip *t = trip_of(transit);
    protocol_note(p, t, MESSAGE_LEFT, now);
    if (t->kind != TRIP_SHORT)
        bytes_moved(p, t, now);
    protocol_trip_ends(p, t->m, now);
}
