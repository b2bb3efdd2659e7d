/* proto.c - see proto.h. Each function below is one arrow's end in its drawing. */
#include <assert.h>
#include <stddef.h>
#include <stdlib.h>
#include "net/proto_parts.h"

static void started(void *ctx, struct wire_transit *t, vtime now);
static void done(void *ctx, struct wire_transit *t, vtime now);

struct proto *proto_new(const struct cfg_machine *cfg, const struct topo *topo, struct evq *q,
                        const struct proto_nodes *nodes)
{
    struct proto *p = calloc(1, sizeof *p);
    if (!p)
        return NULL;
    p->cfg = cfg, p->topo = *topo, p->q = q, p->nodes = *nodes;
    p->least_milli = cfg->fast_every && cfg_fast_system_milli(cfg) < 1000 ? cfg_fast_system_milli(cfg) : 1000;
    for (unsigned i = 0; i < PROTO_SIZES; i++)
        p->messages[i].bytes = sizeof(struct message) + PROTO_IN_MESSAGE[i];
    p->trips.bytes = sizeof(struct trip);
    p->wire = wire_new(topo, q, &(struct wire_calls){p, started, done});
    p->places = calloc(topo->places, sizeof *p->places);
    if (!p->wire || !p->places) {
        proto_free(p);
        return NULL;
    }
    return p;
}

void proto_free(struct proto *p)
{
    if (!p)
        return;
    for (uint32_t i = 0; p->places && i < p->topo.places; i++)
        while (p->places[i].in)
            proto_message_free(p->places[i].in->m);
    wire_free(p->wire);
    free(p->places);
    for (unsigned i = 0; i < PROTO_SIZES; i++)
        arena_free(&p->messages[i]);
    arena_free(&p->trips);
    free(p);
}

vtime proto_send_time(const struct proto *p, int32_t type, size_t bytes)
{
    if (bytes <= p->cfg->short_limit)
        return p->cfg->short_send_ps;
    return type & PROTO_FORCED ? p->cfg->forced_send_ps : p->cfg->ask_send_ps;
}

/* So many messages are not looked through each time: something comes at any moment. */
enum { MANY = 256 };

vtime proto_horizon(const struct proto *p, uint32_t node, vtime next)
{
    /* A message that is not under way yet is sent at `next` at the earliest, and takes the sender's time to
     * leave. */
    if (next == VT_NEVER)
        return VT_NEVER;
    vtime horizon = next + proto_least_send_time(p);
    unsigned many = 0;
    for (const struct trip *t = p->places[node].in; t && ++many < MANY; t = t->next_in)
        horizon = vt_min(horizon, vt_max(t->at_receiver.at, next + t->at_receiver.after));
    for (const struct trip *t = p->places[node].out; t && ++many < MANY; t = t->next_out)
        horizon = vt_min(horizon, vt_max(t->at_sender.at, next + t->at_sender.after));
    return many < MANY ? horizon : next;
}

void proto_set_nodes(struct proto *p, uint32_t n)
{
    p->topo.nodes = n;
}

/* --- sending --- */

static void ask_arrives(void *ctx, void *arg, vtime now);
static void inject(void *ctx, void *arg, vtime now);

void proto_send(struct proto *p, struct message *m, vtime when)
{
    if (!m->trip)
        proto_begin_trip(p, m);
    struct trip *t = m->trip;
    const struct evq_sender sender = {t->source, t->order};
    t->followed = m->followed;
    if (!t->link_in)
        proto_link(p, t);
    if (m->is_long) {
        t->at_sender = proto_at(when + 2 * proto_trip(p, m));
        t->at_receiver = proto_at(when + proto_trip(p, m));
        evq_put_sent(p->q, when + proto_trip(p, m), m->to, sender, ask_arrives, p, m);
    } else {
        t->at_sender = t->by_hand || t->followed ? proto_at(when) : PROTO_NOTHING;
        t->at_receiver = proto_at(when);
        evq_put_sent(p->q, when, m->from, sender, inject, p, t);
    }
}

void proto_take_back(struct message *m)
{
    m->trip->taken_back = true;
    proto_envelope_seen(m->proto, m->trip); /* nobody waits for it */
    proto_unlink_out(m->trip);
}

/* The receiver of m sends on what it is to send on, from `when` on; returns when it is done with that. */
static vtime pass_on(struct proto *p, struct message *m, vtime when)
{
    for (struct message *o = m->trip->pass_on, *next; o; o = next) {
        next = o->next;
        when = p->nodes.work(p->nodes.ctx, o->from, PROTO_SEND, when, proto_send_time(p, o->type, o->bytes));
        proto_send(p, o, when);
    }
    m->trip->pass_on = NULL;
    return when;
}

/* --- envelopes, in the order sent --- */

static void look_at(struct proto *p, struct message *m, vtime now);

/* Is there a message under way between the same programs, sent earlier, whose envelope has not come? */
static bool must_wait(const struct proto *p, const struct message *m)
{
    return proto_first_coming(p, m->trip->source, m->to) != m->trip;
}

/* The envelope that waited for the one just seen, if it has come: the next in order. */
static struct message *released(const struct proto *p, uint32_t source, uint32_t to)
{
    const struct trip *first = proto_first_coming(p, source, to);
    return first && first->waits ? first->m : NULL;
}

/* An envelope has come: look at it unless an earlier one is still to come, and then at those that waited for it. */
static void envelope_comes(struct proto *p, struct message *m, vtime now)
{
    if (must_wait(p, m)) {
        m->trip->waits = true;
        m->trip->at_receiver = proto_after(0);
        return;
    }
    uint32_t source = m->source, to = m->to;
    do {
        look_at(p, m, now);
        m = released(p, source, to);
    } while (m);
}

static void whole_message(struct proto *p, struct message *m, vtime now);

static void look_at(struct proto *p, struct message *m, vtime now)
{
    proto_envelope_seen(p, m->trip);
    if (!m->is_long) {
        whole_message(p, m, now);
        return;
    }
    vtime answered = p->nodes.work(p->nodes.ctx, m->to, PROTO_RECEIVE, now, p->cfg->ask_receive_ps);
    m->trip->at_receiver = m->trip->at_sender = proto_after(proto_trip(p, m));
    if (p->nodes.envelope(p->nodes.ctx, m, now))
        proto_grant(p, m, answered);
}

static void ask_arrives(void *ctx, void *arg, vtime now)
{
    struct message *m = arg;
    if (m->trip->taken_back)
        proto_message_free(m);
    else
        envelope_comes(ctx, m, now);
}

/* --- the second and third trip --- */

static void grant_arrives(void *ctx, void *arg, vtime now)
{
    struct proto *p = ctx;
    struct message *m = arg;
    vtime ready = p->nodes.work(p->nodes.ctx, m->from, PROTO_SEND, now, p->cfg->grant_receive_ps);
    m->trip->at_sender = proto_at(ready);
    m->trip->at_receiver = proto_at(ready + proto_trip(p, m));
    evq_put(p->q, ready, m->from, inject, p, m->trip);
}

void proto_grant(struct proto *p, struct message *m, vtime when)
{
    assert(m->is_long && !m->granted);
    m->granted = true;
    m->trip->at_sender = proto_at(when + proto_trip(p, m));
    m->trip->at_receiver = proto_at(when + proto_trip(p, m) + proto_least(p, p->cfg->grant_receive_ps));
    evq_put(p->q, when + proto_trip(p, m), m->from, grant_arrives, p, m);
}

static void sent(struct proto *p, struct trip *t, vtime now)
{
    proto_unlink_out(t);
    if (t->followed && t->m->followed)
        p->nodes.sent(p->nodes.ctx, t->m, now);
}

static void inject(void *ctx, void *arg, vtime now)
{
    struct proto *p = ctx;
    struct trip *t = arg;
    if (t->taken_back) {
        proto_message_free(t->m);
        return;
    }
    if (t->by_hand)
        p->nodes.move(p->nodes.ctx, t->transit.from, PROTO_SEND, now, t->m->bytes * p->cfg->send_ps_per_byte);
    vtime duration = t->transit.duration;
    t->at_sender = proto_at(now + duration); /* a handler may be due when it has left; and it may wait */
    t->at_sender.after = duration;
    t->at_receiver = proto_after(t->by_hand ? proto_trip(p, t->m) : duration);
    if (!t->is_long)
        sent(p, t, now); /* it lies in the operating system's memory: the caller's buffer is free */
    wire_send(p->wire, &t->transit, now);
}

static struct trip *trip_of(struct wire_transit *t)
{
    return (struct trip *)((char *)t - offsetof(struct trip, transit));
}

static void data_flow(void *ctx, void *arg, vtime now)
{
    struct proto *p = ctx;
    struct message *m = arg;
    p->nodes.move(p->nodes.ctx, m->to, PROTO_RECEIVE, now, m->bytes * p->cfg->receive_ps_per_byte);
    m->trip->at_receiver = proto_at(now + m->bytes * p->cfg->long_ps_per_byte);
}

static void started(void *ctx, struct wire_transit *transit, vtime now)
{
    struct proto *p = ctx;
    struct trip *t = trip_of(transit);
    t->at_sender = proto_at(now + transit->duration);
    if (!t->by_hand) {
        t->at_receiver = proto_at(now + transit->duration);
        return;
    }
    vtime trip = proto_trip(p, t->m);
    t->at_receiver = proto_at(now + trip);
    evq_put(p->q, now + trip, transit->to, data_flow, p, t->m);
}

/* --- arrival --- */

static void complete(struct proto *p, struct message *m, vtime now, vtime system)
{
    m->complete = pass_on(p, m, p->nodes.work(p->nodes.ctx, m->to, PROTO_RECEIVE, now, system));
    m->arrived = true;
    proto_end_trip(p, m);
    p->nodes.arrived(p->nodes.ctx, m, now);
}

static void whole_message(struct proto *p, struct message *m, vtime now)
{
    vtime system = m->bytes <= p->cfg->short_limit ? p->cfg->short_receive_ps : p->cfg->forced_receive_ps;
    if (p->nodes.envelope(p->nodes.ctx, m, now)) {
        complete(p, m, now, system);
    } else {
        assert(m->forced);
        pass_on(p, m, p->nodes.work(p->nodes.ctx, m->to, PROTO_RECEIVE, now, system));
        proto_message_free(m);
    }
}

static void done(void *ctx, struct wire_transit *transit, vtime now)
{
    struct proto *p = ctx;
    struct trip *t = trip_of(transit);
    struct message *m = t->m;
    if (!t->is_long) {
        envelope_comes(p, m, now);
        return;
    }
    sent(p, t, now);
    complete(p, m, now, p->cfg->long_receive_ps);
}

uint64_t proto_under_way(const struct proto *p)
{
    return p->under_way;
}

const struct wire *proto_wire(const struct proto *p)
{
    return p->wire;
}
