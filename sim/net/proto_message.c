/* proto_message.c - messages: their making, their bytes, and the lists of those under way. See proto_parts.h. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/queues.h"
#include "net/proto_parts.h"

static vtime hops_time(const struct proto *p, const struct message *m, vtime per_hop)
{
    return topo_hops(&p->topo, m->from, m->to) * per_hop;
}

/* Does it use the host's link? */
static bool is_hosts(const struct proto *p, const struct message *m)
{
    return topo_is_host(&p->topo, m->from) || topo_is_host(&p->topo, m->to);
}

static vtime link_time(const struct proto *p, const struct message *m)
{
    return is_hosts(p, m) ? p->cfg->host.link_ps : 0;
}

vtime proto_trip(const struct proto *p, const struct message *m)
{
    return link_time(p, m) + hops_time(p, m, p->cfg->long_hop_ps);
}

bool proto_one_trip(const struct proto *p, int32_t type, size_t bytes)
{
    return bytes <= p->cfg->short_limit || (type & PROTO_FORCED);
}

/* --- which messages are under way --- */

void proto_begin_trip(struct proto *p, struct message *m)
{
    const struct cfg_machine *c = p->cfg;
    bool small = m->bytes <= c->short_limit;
    vtime hops = link_time(p, m) + hops_time(p, m, small ? c->short_hop_ps : c->long_hop_ps);
    vtime per_byte = is_hosts(p, m) ? c->host.link_ps_per_byte
                     : small        ? c->short_ps_per_byte
                                    : c->long_ps_per_byte;
    struct trip *t = m->trip = arena_take(&p->trips);
    t->m = m;
    t->link_in = t->link_out = NULL;
    t->order = m->order, t->source = m->source;
    t->waits = t->envelope = t->taken_back = false;
    t->is_long = m->is_long, t->by_hand = !small;
    t->pass_on = NULL;
    t->transit.from = m->from, t->transit.to = m->to;
    t->transit.duration = hops + m->bytes * per_byte;
    t->transit.holds = c->channel_ps_per_byte ? hops + m->bytes * c->channel_ps_per_byte : 0;
}

/* So many are looked through one by one: no more than some lines of the cache. */
enum { FEW_COMING = 16 };

static void begin_flows(struct proto_place *to)
{
    to->flows = queues_new();
    for (struct trip *t = to->in; t; t = t->next_in)
        if (!t->envelope)
            queues_add(to->flows, t->source, (int64_t)t->order, t);
}

void proto_link(struct proto *p, struct trip *t)
{
    struct proto_place *to = &p->places[t->transit.to], *from = &p->places[t->transit.from];
    t->next_in = to->in, t->link_in = &to->in;
    t->next_out = from->out, t->link_out = &from->out;
    if (t->next_in)
        t->next_in->link_in = &t->next_in;
    if (t->next_out)
        t->next_out->link_out = &t->next_out;
    *t->link_in = t, *t->link_out = t;
    p->under_way++;
    if (++to->coming > FEW_COMING && !to->flows)
        begin_flows(to);
    else if (to->flows)
        queues_add(to->flows, t->source, (int64_t)t->order, t);
}

void proto_envelope_seen(struct proto *p, struct trip *t)
{
    struct proto_place *to = &p->places[t->transit.to];
    if (to->flows && !t->envelope)
        queues_remove(to->flows, t->source, t);
    t->envelope = true;
}

struct trip *proto_first_coming(const struct proto *p, uint32_t source, uint32_t to)
{
    const struct proto_place *place = &p->places[to];
    if (place->flows)
        return queues_at(place->flows, source, 0);
    struct trip *first = NULL;
    for (struct trip *t = place->in; t; t = t->next_in)
        if (t->source == source && !t->envelope && (!first || t->order < first->order))
            first = t;
    return first;
}

void proto_unlink_out(struct trip *t)
{
    if (!t->link_out)
        return;
    if (t->next_out)
        t->next_out->link_out = t->link_out;
    *t->link_out = t->next_out;
    t->link_out = NULL;
}

static void unlink_in(struct proto *p, struct trip *t)
{
    if (!t->link_in)
        return;
    if (t->next_in)
        t->next_in->link_in = t->link_in;
    *t->link_in = t->next_in;
    p->under_way--;
    proto_envelope_seen(p, t);
    struct proto_place *to = &p->places[t->transit.to];
    if (--to->coming == 0 && to->flows) {
        queues_free(to->flows);
        to->flows = NULL;
    }
}

void proto_end_trip(struct proto *p, struct message *m)
{
    struct trip *t = m->trip;
    m->trip = NULL;
    unlink_in(p, t);
    proto_unlink_out(t);
    arena_give(&p->trips, t);
}

static struct message *message_of(const struct trip *t)
{
    return t ? t->m : NULL;
}

struct message *proto_to(const struct proto *p, uint32_t place)
{
    return message_of(p->places[place].in);
}

struct message *proto_next_to(const struct message *m)
{
    return message_of(m->trip->next_in);
}

struct message *proto_from(const struct proto *p, uint32_t place)
{
    return message_of(p->places[place].out);
}

struct message *proto_next_from(const struct message *m)
{
    return message_of(m->trip->next_out);
}

/* --- their making --- */

/* What message.data points into: the bytes, and how many messages share them. */
struct payload {
    size_t users;
    char bytes[];
};

static struct payload *payload_of(void *data)
{
    return (struct payload *)((char *)data - offsetof(struct payload, bytes));
}

void *proto_payload(const void *data, size_t bytes)
{
    if (!data)
        return NULL;
    struct payload *p = malloc(sizeof *p + bytes);
    if (!p)
        abort();
    p->users = 0;
    memcpy(p->bytes, data, bytes);
    return p->bytes;
}

static void release(struct message *m)
{
    if (m->data && m->data != m->few && --payload_of(m->data)->users == 0)
        free(payload_of(m->data));
}

/* The size of a message with so many bytes in itself. */
static unsigned size_for(size_t bytes)
{
    return bytes <= PROTO_IN_MESSAGE[PROTO_FEW] ? PROTO_FEW : PROTO_SHORT;
}

static struct arena *pool_of(const struct message *m)
{
    return &m->proto->messages[m->data == m->few ? size_for(m->bytes) : PROTO_FEW];
}

static struct message *message_new(struct proto *p, enum proto_size size, uint32_t from, uint32_t to,
                                   int32_t type, int32_t pid, size_t bytes)
{
    struct message *m = arena_take(&p->messages[size]);
    m->next = NULL, m->receive = NULL, m->trip = NULL, m->proto = p;
    m->type = type, m->pid = pid, m->bytes = bytes;
    m->from = m->source = from, m->to = to;
    m->order = p->places[from].made++;
    m->is_long = !proto_one_trip(p, type, bytes), m->forced = (type & PROTO_FORCED) != 0;
    m->serves = m->followed = m->granted = m->arrived = m->buffered = m->unwanted = m->too_long = m->whole =
        false;
    return m;
}

struct message *proto_message_sharing(struct proto *p, uint32_t from, uint32_t to, int32_t type, int32_t pid,
                                      void *payload, size_t bytes)
{
    struct message *m = message_new(p, PROTO_FEW, from, to, type, pid, bytes);
    m->data = payload;
    if (payload)
        payload_of(payload)->users++;
    return m;
}

struct message *proto_message(struct proto *p, uint32_t from, uint32_t to, int32_t type, int32_t pid,
                              const void *data, size_t bytes)
{
    if (!data || bytes > PROTO_IN_MESSAGE[PROTO_SHORT])
        return proto_message_sharing(p, from, to, type, pid, proto_payload(data, bytes), bytes);
    struct message *m = message_new(p, size_for(bytes), from, to, type, pid, bytes);
    m->data = memcpy(m->few, data, bytes);
    return m;
}

void proto_message_free(struct message *m)
{
    if (m->trip)
        proto_end_trip(m->proto, m);
    release(m);
    arena_give(pool_of(m), m);
}

bool proto_message_is_plain(const struct message *m)
{
    return m->arrived && m->data == m->few && size_for(m->bytes) == PROTO_FEW;
}

void proto_message_free_plain(struct proto *p, struct message *m)
{
    arena_give(&p->messages[PROTO_FEW], m);
}
