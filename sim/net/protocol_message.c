/* protocol_message.c - messages: their making, their bytes, and the lists of those under way: see
 * protocol_parts.h. */
#include <assert.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/queues.h"
#include "kernel/xalloc.h"
#include "net/protocol_parts.h"

static vtime hops_time(const struct protocol *p, const struct message *m, vtime per_hop)
{
    return topo_hops(&p->topo, m->from, m->to) * per_hop;
}

/* Does the message use the host's link? */
static bool is_hosts(const struct protocol *p, const struct message *m)
{
    return topo_is_host(&p->topo, m->from) || topo_is_host(&p->topo, m->to);
}

static vtime link_time(const struct protocol *p, const struct message *m)
{
    return is_hosts(p, m) ? p->cfg->host.link_ps : 0;
}

__attribute__((noinline)) vtime protocol_latency(const struct protocol *p, const struct message *m)
{
    return link_time(p, m) + hops_time(p, m, p->cfg->long_hop_ps);
}

bool protocol_is_eager(const struct protocol *p, int32_t type, size_t bytes)
{
    return bytes <= p->cfg->short_limit || (type & PROTOCOL_FORCED);
}

/* --- which messages are under way --- */

void protocol_begin_trip(struct protocol *p, struct message *m)
{
    const struct cfg_machine *c = p->cfg;
    bool small = m->bytes <= c->short_limit && !m->is_long;
    vtime hops = link_time(p, m) + hops_time(p, m, small ? c->short_hop_ps : c->long_hop_ps);
    vtime per_byte = is_hosts(p, m) ? c->host.link_ps_per_byte
                     : small        ? c->short_ps_per_byte
                                    : c->long_ps_per_byte;
    struct trip *t = m->trip = arena_take(&p->trips);
    t->m = m;
    t->link_in = t->link_out = NULL;
    t->order = m->order, t->source = m->source;
    t->envelope = TRIP_COMING, t->taken_back = t->followed = false;
    t->kind = small ? TRIP_SHORT : m->is_long ? TRIP_LONG : TRIP_FORCED;
    t->forward = NULL;
    if (p->recorder)
        protocol_note_begin(t);
    t->transit.from = m->from, t->transit.to = m->to;
    t->transit.duration = hops + m->bytes * per_byte;
    t->transit.holds = c->channel_ps_per_byte ? hops + m->bytes * c->channel_ps_per_byte : 0;
}

/* A list of so many messages is searched one by one: no more than some lines of the cache. */
enum { FEW_COMING = 16 };

static void begin_flows(struct protocol_endpoint *to)
{
    to->flows = queues_new();
    for (struct trip *t = to->in; t; t = t->next_in)
        if (t->envelope != TRIP_SEEN)
            queues_add(to->flows, t->source, (int64_t)t->order, t);
}

void protocol_link_out(struct protocol *p, struct trip *t)
{
    struct protocol_endpoint *from = &p->endpoints[t->transit.from];
    t->next_out = from->out, t->link_out = &from->out;
    if (t->next_out)
        t->next_out->link_out = &t->next_out;
    from->out = t;
}

void protocol_link_in(struct protocol *p, struct trip *t)
{
    struct protocol_endpoint *to = &p->endpoints[t->transit.to];
    t->next_in = to->in, t->link_in = &to->in;
    if (t->next_in)
        t->next_in->link_in = &t->next_in;
    to->in = t;
    p->under_way++;
    if (++to->coming > FEW_COMING && !to->flows)
        begin_flows(to);
    else if (to->flows)
        queues_add(to->flows, t->source, (int64_t)t->order, t);
}

void protocol_envelope_seen(struct protocol *p, struct trip *t)
{
    struct protocol_endpoint *to = &p->endpoints[t->transit.to];
    if (to->flows && t->envelope != TRIP_SEEN)
        queues_remove(to->flows, t->source, t);
    t->envelope = TRIP_SEEN;
}

struct trip *protocol_first_coming(const struct protocol *p, uint32_t source, uint32_t to)
{
    const struct protocol_endpoint *at = &p->endpoints[to];
    if (at->flows)
        return queues_at(at->flows, source, 0);
    struct trip *first = NULL;
    for (struct trip *t = at->in; t; t = t->next_in)
        if (t->source == source && t->envelope != TRIP_SEEN && (!first || t->order < first->order))
            first = t;
    return first;
}

void protocol_unlink_out(struct trip *t)
{
    if (!t->link_out)
        return;
    if (t->next_out)
        t->next_out->link_out = t->link_out;
    *t->link_out = t->next_out;
    t->link_out = NULL;
}

static void unlink_in(struct protocol *p, struct trip *t)
{
    if (!t->link_in)
        return;
    if (t->next_in)
        t->next_in->link_in = t->link_in;
    *t->link_in = t->next_in;
    assert(p->under_way > 0);
    p->under_way--;
    protocol_envelope_seen(p, t);
    struct protocol_endpoint *to = &p->endpoints[t->transit.to];
    if (--to->coming == 0 && to->flows) {
        queues_free(to->flows);
        to->flows = NULL;
    }
}

void protocol_end_trip(struct protocol *p, struct message *m)
{
    struct trip *t = m->trip;
    if (p->recorder)
        protocol_note_end(p, t);
    m->trip = NULL;
    unlink_in(p, t);
    protocol_unlink_out(t);
    arena_give(&p->trips, t);
}

static struct message *message_of(const struct trip *t)
{
    return t ? t->m : NULL;
}

struct message *protocol_to(const struct protocol *p, uint32_t address)
{
    return message_of(p->endpoints[address].in);
}

struct message *protocol_next_to(const struct message *m)
{
    return message_of(m->trip->next_in);
}

struct message *protocol_from(const struct protocol *p, uint32_t address)
{
    return message_of(p->endpoints[address].out);
}

struct message *protocol_next_from(const struct message *m)
{
    return message_of(m->trip->next_out);
}

/* --- their making --- */

/* What message.data points into, if not into the message: the bytes, and how many messages share them. */
struct payload {
    size_t users;
    char bytes[];
};

static struct payload *payload_of(void *data)
{
    return (struct payload *)((char *)data - offsetof(struct payload, bytes));
}

void *protocol_payload(const void *data, size_t bytes)
{
    if (!data)
        return NULL;
    struct payload *p = xmalloc(sizeof *p + bytes);
    p->users = 0;
    memcpy(p->bytes, data, bytes);
    return p->bytes;
}

/* The message has no further use for its data, which are not in itself. */
static void release_data(struct message *m)
{
    if (!m->data)
        return;
    struct payload *p = payload_of(m->data);
    assert(p->users > 0);
    if (--p->users == 0)
        free(p);
}

/* The size of a message with so many bytes in itself. */
static unsigned size_for(size_t bytes)
{
    return bytes <= PROTOCOL_IN_MESSAGE[PROTOCOL_FEW] ? PROTOCOL_FEW : PROTOCOL_SHORT;
}

struct arena *protocol_pool_of(const struct message *m)
{
    return &m->protocol->messages[m->data == m->few ? size_for(m->bytes) : PROTOCOL_FEW];
}

static struct message *message_new(struct protocol *p, enum protocol_size size, uint32_t from, uint32_t to,
                                   int32_t type, int32_t pid, size_t bytes)
{
    struct message *m = arena_take(&p->messages[size]);
    m->next = NULL, m->receive = NULL, m->trip = NULL, m->protocol = p;
    m->type = type, m->pid = pid, m->bytes = bytes;
    m->from = m->source = from, m->to = to;
    m->order = p->endpoints[from].made++;
    m->is_long = !protocol_is_eager(p, type, bytes), m->forced = (type & PROTOCOL_FORCED) != 0;
    m->serves = m->carries = m->followed = m->cleared = m->arrived = m->buffered = m->unwanted = m->too_long =
        m->whole = m->in_order = m->held = false;
    return m;
}

void protocol_hold(struct message *m)
{
    assert(!m->trip && !m->forced);
    m->is_long = m->held = true;
}

struct message *protocol_message_sharing(struct protocol *p, uint32_t from, uint32_t to, int32_t type,
                                         int32_t pid, void *payload, size_t bytes)
{
    struct message *m = message_new(p, PROTOCOL_FEW, from, to, type, pid, bytes);
    m->data = payload;
    if (payload)
        payload_of(payload)->users++;
    return m;
}

struct message *protocol_message(struct protocol *p, uint32_t from, uint32_t to, int32_t type, int32_t pid,
                                 const void *data, size_t bytes)
{
    if (!data || bytes > PROTOCOL_IN_MESSAGE[PROTOCOL_SHORT])
        return protocol_message_sharing(p, from, to, type, pid, protocol_payload(data, bytes), bytes);
    struct message *m = message_new(p, size_for(bytes), from, to, type, pid, bytes);
    m->data = memcpy(m->few, data, bytes);
    return m;
}

void protocol_carry(struct message *first, struct protocol_cargo *cargo)
{
    for (struct message *m = first; m; m = m->next) {
        assert(!m->serves && !m->carries);
        m->cargo = cargo, m->carries = true;
        cargo->users++;
        if (m->trip)
            protocol_carry(m->trip->forward, cargo);
    }
}

static void release_cargo(struct message *m)
{
    if (--m->cargo->users == 0)
        m->cargo->end(m->cargo);
    m->carries = false;
}

/* What the message has beside itself. */
static __attribute__((noinline)) void release_parts(struct message *m)
{
    if (m->trip)
        protocol_end_trip(m->protocol, m);
    if (m->carries)
        release_cargo(m);
    if (m->data != m->few)
        release_data(m);
}

void protocol_message_free(struct message *m)
{
    assert(m->protocol); /* not freed yet */
    if (m->trip || m->carries || m->data != m->few)
        release_parts(m);
    struct arena *pool = protocol_pool_of(m);
    m->protocol = NULL;
    arena_give(pool, m);
}

bool protocol_message_is_plain(const struct message *m)
{
    return m->arrived && !m->carries && m->data == m->few && size_for(m->bytes) == PROTOCOL_FEW;
}

void protocol_message_free_plain(struct protocol *p, struct message *m)
{
    arena_give(&p->messages[PROTOCOL_FEW], m);
}
