/* protocol.c - see protocol.h. Each function below is one arrow's end in its drawing. */
#include <assert.h>
#include <stddef.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "net/protocol_parts.h"

struct protocol *protocol_new(const struct cfg_machine *cfg, const struct topo *topo, struct evq *q,
                              void *ends)
{
    struct protocol *p = xcalloc(1, sizeof *p);
    p->cfg = cfg, p->topo = *topo, p->q = q, p->ends = ends;
    p->least_milli = cfg->fast_every && cfg_fast_system_milli(cfg) < 1000 ? cfg_fast_system_milli(cfg) : 1000;
    for (unsigned i = 0; i < PROTOCOL_SIZES; i++)
        p->messages[i].bytes = sizeof(struct message) + PROTOCOL_IN_MESSAGE[i];
    p->trips.bytes = sizeof(struct trip);
    p->channels = channel_new(
        topo, q, &(struct channel_calls){p, protocol_trip_started, protocol_trip_done, NULL, NULL});
    p->endpoints = xcalloc(topo->addresses, sizeof *p->endpoints);
    if (cfg->moves_at_once)
        p->movers = movers_new(topo->addresses, cfg->moves_at_once, protocol_places_found, p);
    return p;
}

void protocol_free(struct protocol *p)
{
    if (!p)
        return;
    for (uint32_t i = 0; i < p->topo.addresses; i++)
        while (p->endpoints[i].in)
            protocol_message_free(p->endpoints[i].in->m);
    assert(p->under_way == 0);
    channel_free(p->channels);
    movers_free(p->movers);
    free(p->endpoints);
    for (unsigned i = 0; i < PROTOCOL_SIZES; i++)
        arena_free(&p->messages[i]);
    arena_free(&p->trips);
    free(p);
}

vtime protocol_send_time(const struct protocol *p, int32_t type, size_t bytes)
{
    if (bytes <= p->cfg->short_limit)
        return p->cfg->short_send_ps;
    return type & PROTOCOL_FORCED ? p->cfg->forced_send_ps : p->cfg->ask_send_ps;
}

/* A list of so many messages is not searched: something may come at any moment. */
enum { MANY = 256 };

vtime protocol_horizon(const struct protocol *p, uint32_t node, vtime next)
{
    /* A message that is not under way yet is sent at `next` at the earliest, and takes processor time of its
     * sender. */
    if (next == VT_NEVER)
        return VT_NEVER;
    vtime horizon = next + protocol_least_send_time(p);
    unsigned many = 0;
    for (const struct trip *t = p->endpoints[node].in; t && ++many < MANY; t = t->next_in)
        horizon = vt_min(horizon, vt_max(t->at_receiver.at, next + t->at_receiver.after));
    for (const struct trip *t = p->endpoints[node].out; t && ++many < MANY; t = t->next_out)
        horizon = vt_min(horizon, vt_max(t->at_sender.at, next + t->at_sender.after));
    return many < MANY ? horizon : next;
}

void protocol_set_nodes(struct protocol *p, uint32_t n)
{
    p->topo.nodes = n;
}

/* --- sending --- */

static void request_arrives(void *ctx, void *arg, vtime now);

void protocol_send(struct protocol *p, struct message *m, vtime at)
{
    protocol_send_late(p, m, at, 0);
}

void protocol_send_late(struct protocol *p, struct message *m, vtime at, vtime late)
{
    vtime when = at + late;
    if (!m->trip)
        protocol_begin_trip(p, m);
    struct trip *t = m->trip;
    const struct evq_sender sender = {t->source, t->order};
    t->followed = m->followed;
    protocol_note(p, t, MESSAGE_TIMES, at);
    if (!t->link_in)
        protocol_link_in(p, t);
    if (t->kind != TRIP_SHORT || t->followed)
        protocol_link_out(p, t);
    if (m->is_long) {
        vtime latency = protocol_latency(p, m);
        t->at_sender = protocol_at(when + 2 * latency);
        t->at_receiver = protocol_at(when + latency);
        evq_put_sent(p->q, when + latency, m->to, sender, request_arrives, p, m);
    } else {
        t->at_sender = t->kind != TRIP_SHORT || t->followed ? protocol_at(when) : PROTOCOL_NOTHING;
        t->at_receiver = protocol_at(when);
        evq_put_sent(p->q, when, m->from, sender, protocol_inject, p, t);
    }
}

void protocol_take_back(struct message *m)
{
    m->trip->taken_back = true;
    protocol_envelope_seen(m->protocol, m->trip); /* later envelopes do not wait for it */
    protocol_unlink_out(m->trip);
}

/* The receiver of m forwards it along the tree, from `when` on; returns when the receiver has done so. */
static inline vtime forward(struct protocol *p, struct message *m, vtime when)
{
    for (struct message *o = m->trip->forward, *next; o; o = next) {
        next = o->next;
        when = endpoint_work(p->ends, o->from, PROTOCOL_SEND, when, protocol_send_time(p, o->type, o->bytes));
        protocol_send(p, o, when);
    }
    m->trip->forward = NULL;
    return when;
}

/* --- envelopes, handled in the order sent --- */

static void handle_envelope(struct protocol *p, struct message *m, vtime now);

/* Is a message under way between the same programs that was sent earlier, and whose envelope has not come? */
static bool must_wait(const struct protocol *p, const struct message *m)
{
    return p->endpoints[m->to].coming > 1 && protocol_first_coming(p, m->trip->source, m->to) != m->trip;
}

/* The message next in order, if its envelope has come and waited for the one just handled. NULL: none. */
static struct message *released(const struct protocol *p, uint32_t source, uint32_t to)
{
    struct protocol_endpoint *at = &p->endpoints[to];
    const struct trip *first = at->waiting ? protocol_first_coming(p, source, to) : NULL;
    if (!first || first->envelope != TRIP_WAITS)
        return NULL;
    at->waiting--;
    return first->m;
}

/* An envelope has come: the receiver handles it unless an earlier one is still to come, and then those that
 * waited for it. */
static inline __attribute__((always_inline)) void envelope_comes(struct protocol *p, struct message *m,
                                                                 vtime now)
{
    if (must_wait(p, m)) {
        m->trip->envelope = TRIP_WAITS;
        p->endpoints[m->to].waiting++;
        m->trip->at_receiver = protocol_after(0);
        return;
    }
    uint32_t source = m->source, to = m->to;
    do {
        handle_envelope(p, m, now);
        m = released(p, source, to);
    } while (m);
}

static void whole_message(struct protocol *p, struct message *m, vtime now);

static void handle_envelope(struct protocol *p, struct message *m, vtime now)
{
    protocol_envelope_seen(p, m->trip);
    if (!m->is_long) {
        whole_message(p, m, now);
        return;
    }
    vtime answered = endpoint_work(p->ends, m->to, PROTOCOL_RECEIVE, now, p->cfg->ask_receive_ps);
    m->trip->at_receiver = m->trip->at_sender = protocol_after(protocol_latency(p, m));
    if (!m->serves && !m->carries)
        m->asked = answered;
    if (endpoint_envelope(p->ends, m, now))
        protocol_clear_to_send(p, m, answered);
}

static void request_arrives(void *ctx, void *arg, vtime now)
{
    struct message *m = arg;
    if (m->trip->taken_back)
        protocol_message_free(m);
    else
        protocol_note(ctx, m->trip, MESSAGE_ASKED, now), envelope_comes(ctx, m, now);
}

/* --- the second and third trip --- */

static void clear_to_send_arrives(void *ctx, void *arg, vtime now)
{
    struct protocol *p = ctx;
    struct message *m = arg;
    vtime ready = endpoint_work(p->ends, m->from, PROTOCOL_SEND, now, p->cfg->grant_receive_ps);
    m->trip->at_sender = protocol_at(ready);
    m->trip->at_receiver = protocol_at(ready + protocol_latency(p, m));
    evq_put(p->q, ready, m->from, protocol_inject, p, m->trip);
}

void protocol_clear_to_send(struct protocol *p, struct message *m, vtime when)
{
    assert(m->is_long && !m->cleared);
    m->cleared = true;
    protocol_note(p, m->trip, MESSAGE_GRANTED, when);
    vtime arrives = when + protocol_latency(p, m);
    m->trip->at_sender = protocol_at(arrives);
    m->trip->at_receiver = protocol_at(arrives + protocol_least(p, p->cfg->grant_receive_ps));
    evq_put(p->q, arrives, m->from, clear_to_send_arrives, p, m);
}

/* --- arrival --- */

static inline __attribute__((always_inline)) void complete(struct protocol *p, struct message *m, vtime now,
                                                           vtime system)
{
    m->complete = forward(p, m, endpoint_work(p->ends, m->to, PROTOCOL_RECEIVE, now, system));
    m->arrived = true;
    protocol_note(p, m->trip, MESSAGE_COMPLETE, m->complete);
    protocol_end_trip(p, m);
    endpoint_arrived(p->ends, m, now);
}

static inline void whole_message(struct protocol *p, struct message *m, vtime now)
{
    vtime system = m->bytes <= p->cfg->short_limit ? p->cfg->short_receive_ps : p->cfg->forced_receive_ps;
    if (endpoint_envelope(p->ends, m, now)) {
        complete(p, m, now, system);
    } else {
        assert(m->forced);
        forward(p, m, endpoint_work(p->ends, m->to, PROTOCOL_RECEIVE, now, system));
        protocol_message_free(m);
    }
}

/* The tail of the message, or of its data, has passed. */
void protocol_trip_ends(struct protocol *p, struct message *m, vtime now)
{
    if (m->is_long)
        complete(p, m, now, p->cfg->long_receive_ps);
    else
        envelope_comes(p, m, now);
}

uint64_t protocol_under_way(const struct protocol *p)
{
    return p->under_way;
}

const struct channels *protocol_channels(const struct protocol *p)
{
    return p->channels;
}
