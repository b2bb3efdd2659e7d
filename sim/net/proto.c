/* proto.c - see proto.h. Each function below is one arrow's end in its drawing. */
#include "net/proto.h"
#include <assert.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

struct proto {
    const struct cfg_machine *cfg;
    struct topo topo;
    struct evq *q;
    struct wire *wire;
    struct proto_nodes nodes;
    struct message **in, **out; /* by node: messages on their way to it, being sent by it */
    uint64_t sent, under_way;
};

struct proto *proto_new(const struct cfg_machine *cfg, const struct topo *topo, struct evq *q,
                        const struct proto_nodes *nodes)
{
    struct proto *p = calloc(1, sizeof *p);
    if (!p)
        return NULL;
    p->cfg = cfg, p->topo = *topo, p->q = q, p->nodes = *nodes;
    p->wire = wire_new(topo, q);
    p->in = calloc(topo->places, sizeof *p->in);
    p->out = calloc(topo->places, sizeof *p->out);
    if (!p->wire || !p->in || !p->out) {
        proto_free(p);
        return NULL;
    }
    return p;
}

/* --- which messages are under way --- */

static void link_message(struct proto *p, struct message *m)
{
    m->next_in = p->in[m->to], m->link_in = &p->in[m->to];
    m->next_out = p->out[m->from], m->link_out = &p->out[m->from];
    if (m->next_in)
        m->next_in->link_in = &m->next_in;
    if (m->next_out)
        m->next_out->link_out = &m->next_out;
    *m->link_in = m, *m->link_out = m;
    p->under_way++;
}

static void unlink_in(struct message *m)
{
    if (!m->link_in)
        return;
    if (m->next_in)
        m->next_in->link_in = m->link_in;
    *m->link_in = m->next_in;
    m->link_in = NULL;
    m->proto->under_way--;
}

static void unlink_out(struct message *m)
{
    if (!m->link_out)
        return;
    if (m->next_out)
        m->next_out->link_out = m->link_out;
    *m->link_out = m->next_out;
    m->link_out = NULL;
}

void proto_free(struct proto *p)
{
    if (!p)
        return;
    for (uint32_t i = 0; p->in && i < p->topo.places; i++)
        while (p->in[i])
            proto_message_free(p->in[i]);
    wire_free(p->wire);
    free(p->in);
    free(p->out);
    free(p);
}

/* --- times --- */

static const struct proto_bound NOTHING = {.at = VT_NEVER};

static struct proto_bound at(vtime t)
{
    return (struct proto_bound){.at = t};
}

static struct proto_bound after(vtime t)
{
    return (struct proto_bound){.after = t};
}

static vtime hops_time(const struct message *m, vtime per_hop)
{
    return topo_hops(&m->proto->topo, m->from, m->to) * per_hop;
}

static vtime trip(const struct message *m)
{
    return hops_time(m, m->proto->cfg->long_hop_ps);
}

static bool one_trip(const struct proto *p, int64_t type, size_t bytes)
{
    return bytes <= p->cfg->short_limit || (type & PROTO_FORCED);
}

vtime proto_send_time(const struct proto *p, int64_t type, size_t bytes)
{
    return one_trip(p, type, bytes) ? p->cfg->short_send_ps : p->cfg->ask_send_ps;
}

vtime proto_horizon(const struct proto *p, uint32_t node, vtime next)
{
    /* A message that is not under way yet is sent at `next` at the earliest, and takes the sender's time to
     * leave. */
    if (next == VT_NEVER)
        return VT_NEVER;
    vtime horizon = next + vt_min(p->cfg->short_send_ps, p->cfg->ask_send_ps);
    for (const struct message *m = p->in[node]; m; m = m->next_in)
        horizon = vt_min(horizon, vt_max(m->at_receiver.at, next + m->at_receiver.after));
    for (const struct message *m = p->out[node]; m; m = m->next_out)
        horizon = vt_min(horizon, vt_max(m->at_sender.at, next + m->at_sender.after));
    return horizon;
}

/* --- sending --- */

static void on_started(void *ctx, struct wire_transit *t, vtime now);
static void on_done(void *ctx, struct wire_transit *t, vtime now);

/* What message.data points into: the bytes, and how many messages share them. */
struct payload {
    size_t users;
    char bytes[];
};

static struct payload *payload_of(void *data)
{
    return (struct payload *)((char *)data - offsetof(struct payload, bytes));
}

static void *payload_new(const void *data, size_t bytes)
{
    struct payload *p = malloc(sizeof *p + bytes);
    if (!p)
        abort();
    p->users = 0;
    if (data)
        memcpy(p->bytes, data, bytes);
    return p->bytes;
}

static void payload_release(void *data)
{
    if (--payload_of(data)->users == 0)
        free(payload_of(data));
}

/* data: a payload's. */
static struct message *message_new(struct proto *p, uint32_t from, uint32_t to, int64_t type, int64_t pid,
                                   void *data, size_t bytes)
{
    struct message *m = calloc(1, sizeof *m);
    if (!m)
        abort();
    m->data = data;
    payload_of(data)->users++;
    m->proto = p, m->from = m->source = from, m->to = to, m->type = type, m->pid = pid, m->bytes = bytes;
    m->is_long = !one_trip(p, type, bytes);
    m->forced = (type & PROTO_FORCED) != 0;
    m->order = p->sent++;
    m->complete = VT_NEVER;
    const struct cfg_machine *c = p->cfg;
    bool small = bytes <= c->short_limit;
    m->transit =
        (struct wire_transit){.from = from, .to = to, .started = on_started, .done = on_done, .ctx = m};
    vtime hops = hops_time(m, small ? c->short_hop_ps : c->long_hop_ps);
    m->transit.duration = hops + bytes * (small ? c->short_ps_per_byte : c->long_ps_per_byte);
    m->transit.holds = c->channel_ps_per_byte ? hops + bytes * c->channel_ps_per_byte : 0;
    return m;
}

struct message *proto_message(struct proto *p, uint32_t from, uint32_t to, int64_t type, int64_t pid,
                              const void *data, size_t bytes)
{
    return message_new(p, from, to, type, pid, payload_new(data, bytes), bytes);
}

static void ask_arrives(void *ctx, void *arg, vtime now);
static void inject(void *ctx, void *arg, vtime now);

void proto_send(struct proto *p, struct message *m, vtime when)
{
    m->sent_at = when;
    if (!m->link_in)
        link_message(p, m);
    if (m->is_long) {
        m->at_sender = at(when + 2 * trip(m));
        m->at_receiver = at(when + trip(m));
        evq_put(p->q, when + trip(m), m->to, ask_arrives, p, m);
    } else {
        m->at_sender = NOTHING;
        m->at_receiver = at(when);
        evq_put(p->q, when, m->from, inject, p, m);
    }
}

/* --- to all nodes, along a tree --- */

/* What does not change between the messages of one tree. */
struct tree {
    struct proto *p;
    uint32_t root;
    int64_t type, pid;
    void *data;
    size_t bytes;
};

/* The node that is the i-th seen from the root. */
static uint32_t tree_node(const struct tree *t, uint32_t i)
{
    uint32_t n = t->p->topo.nodes;
    return (n & (n - 1)) == 0 ? t->root ^ i : (t->root + i) % n;
}

/* The messages by which i reaches the nodes i to i + count - 1, in the order it sends them. Those that it sends only
 * when it has got its own are under way from now on: so they keep their place among the root's later messages. */
static struct message *tree_messages(const struct tree *t, uint32_t i, uint32_t count)
{
    struct message *first = NULL, **link = &first;
    while (count > 1) {
        uint32_t half = 1;
        while (half * 2 < count)
            half *= 2;
        struct message *m =
            message_new(t->p, tree_node(t, i), tree_node(t, i + half), t->type, t->pid, t->data, t->bytes);
        m->source = t->root;
        if (i > 0) {
            m->at_sender = NOTHING;
            m->at_receiver = after(vt_min(t->p->cfg->short_send_ps, t->p->cfg->ask_send_ps));
            link_message(t->p, m);
        }
        m->pass_on = tree_messages(t, i + half, count - half);
        *link = m;
        link = &m->also;
        count = half;
    }
    return first;
}

struct message *proto_to_all(struct proto *p, uint32_t from, int64_t type, int64_t pid, const void *data,
                             size_t bytes)
{
    if (p->topo.nodes < 2)
        return NULL;
    struct tree t = {.p = p, .root = from, .type = type, .pid = pid, .bytes = bytes};
    t.data = payload_new(data, bytes);
    return tree_messages(&t, 0, p->topo.nodes);
}

/* The receiver of m sends on what it is to send on, from `when` on; returns when it is done with that. */
static vtime pass_on(struct proto *p, struct message *m, vtime when)
{
    for (struct message *o = m->pass_on, *next; o; o = next) {
        next = o->also;
        when = p->nodes.work(p->nodes.ctx, o->from, PROTO_SEND, when, proto_send_time(p, o->type, o->bytes));
        proto_send(p, o, when);
    }
    m->pass_on = NULL;
    return when;
}

/* --- envelopes, in the order sent --- */

static void look_at(struct proto *p, struct message *m, vtime now);

/* Is there a message under way between the same programs, sent earlier, whose envelope has not come? */
static bool must_wait(const struct proto *p, const struct message *m)
{
    for (const struct message *o = p->in [m->to]; o; o = o->next_in)
        if (o->source == m->source && o->order < m->order && !o->envelope)
            return true;
    return false;
}

/* The envelope that waited for the one just seen, if it has come: the next in order. */
static struct message *released(const struct proto *p, uint32_t source, uint32_t to)
{
    struct message *first = NULL;
    for (struct message *o = p->in[to]; o; o = o->next_in)
        if (o->source == source && !o->envelope && (!first || o->order < first->order))
            first = o;
    return first && first->sent_at == VT_NEVER ? first : NULL;
}

/* An envelope has come: look at it unless an earlier one is still to come, and then at those that waited for
 * it. While it waits its sent_at is VT_NEVER. */
static void envelope_comes(struct proto *p, struct message *m, vtime now)
{
    if (must_wait(p, m)) {
        m->sent_at = VT_NEVER;
        m->at_receiver = after(0);
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
    m->envelope = true;
    if (!m->is_long) {
        whole_message(p, m, now);
        return;
    }
    vtime answered = p->nodes.work(p->nodes.ctx, m->to, PROTO_RECEIVE, now, p->cfg->ask_receive_ps);
    m->at_receiver = m->at_sender = after(trip(m));
    if (p->nodes.envelope(p->nodes.ctx, m, now))
        proto_grant(p, m, answered);
}

static void ask_arrives(void *ctx, void *arg, vtime now)
{
    envelope_comes(ctx, arg, now);
}

/* --- the second and third trip --- */

static void grant_arrives(void *ctx, void *arg, vtime now)
{
    struct proto *p = ctx;
    struct message *m = arg;
    vtime ready = p->nodes.work(p->nodes.ctx, m->from, PROTO_SEND, now, p->cfg->grant_receive_ps);
    m->at_sender = at(ready);
    m->at_receiver = at(ready + trip(m));
    evq_put(p->q, ready, m->from, inject, p, m);
}

void proto_grant(struct proto *p, struct message *m, vtime when)
{
    assert(m->is_long && !m->granted);
    m->granted = true;
    m->at_sender = at(when + trip(m));
    m->at_receiver = at(when + trip(m) + p->cfg->grant_receive_ps);
    evq_put(p->q, when + trip(m), m->from, grant_arrives, p, m);
}

/* Long messages and long forced ones are fed and emptied by the processors where the machine has no DMA. */
static bool by_hand(const struct message *m)
{
    return m->bytes > m->proto->cfg->short_limit;
}

static void sent(struct proto *p, struct message *m, vtime now)
{
    m->sent = true;
    unlink_out(m);
    p->nodes.sent(p->nodes.ctx, m, now);
}

static void inject(void *ctx, void *arg, vtime now)
{
    struct proto *p = ctx;
    struct message *m = arg;
    if (by_hand(m))
        p->nodes.move(p->nodes.ctx, m->from, PROTO_SEND, now, m->bytes * p->cfg->send_ps_per_byte);
    m->at_sender = NOTHING;
    m->at_receiver = after(m->is_long ? trip(m) : m->transit.duration);
    if (!m->is_long)
        sent(p, m, now); /* it lies in the operating system's memory: the caller's buffer is free */
    wire_send(p->wire, &m->transit, now);
}

static void data_flow(void *ctx, void *arg, vtime now)
{
    struct proto *p = ctx;
    struct message *m = arg;
    p->nodes.move(p->nodes.ctx, m->to, PROTO_RECEIVE, now, m->bytes * p->cfg->receive_ps_per_byte);
    m->at_receiver = at(now + m->bytes * p->cfg->long_ps_per_byte);
}

static void on_started(void *ctx, struct wire_transit *t, vtime now)
{
    struct message *m = ctx;
    (void)t;
    if (!by_hand(m)) {
        m->at_receiver = at(now + m->transit.duration);
        return;
    }
    m->at_receiver = at(now + trip(m));
    evq_put(m->proto->q, now + trip(m), m->to, data_flow, m->proto, m);
}

/* --- arrival --- */

static void complete(struct proto *p, struct message *m, vtime now, vtime system)
{
    m->complete = pass_on(p, m, p->nodes.work(p->nodes.ctx, m->to, PROTO_RECEIVE, now, system));
    m->arrived = true;
    unlink_in(m);
    p->nodes.arrived(p->nodes.ctx, m, now);
}

static void whole_message(struct proto *p, struct message *m, vtime now)
{
    if (p->nodes.envelope(p->nodes.ctx, m, now)) {
        complete(p, m, now, p->cfg->short_receive_ps);
    } else {
        assert(m->forced);
        pass_on(p, m, p->nodes.work(p->nodes.ctx, m->to, PROTO_RECEIVE, now, p->cfg->short_receive_ps));
        proto_message_free(m);
    }
}

static void on_done(void *ctx, struct wire_transit *t, vtime now)
{
    struct message *m = ctx;
    struct proto *p = m->proto;
    (void)t;
    if (!m->is_long) {
        envelope_comes(p, m, now);
        return;
    }
    sent(p, m, now);
    complete(p, m, now, p->cfg->long_receive_ps);
}

void proto_message_free(struct message *m)
{
    unlink_in(m);
    unlink_out(m);
    payload_release(m->data);
    free(m);
}

uint64_t proto_under_way(const struct proto *p)
{
    return p->under_way;
}

const struct wire *proto_wire(const struct proto *p)
{
    return p->wire;
}
