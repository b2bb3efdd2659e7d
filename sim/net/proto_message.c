/* proto_message.c - messages: their making, their bytes, and the lists of those under way. See proto_parts.h. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include "net/proto_parts.h"

static vtime hops_time(const struct message *m, vtime per_hop)
{
    return topo_hops(&m->proto->topo, m->from, m->to) * per_hop;
}

/* Does it use the host's link? */
static bool is_hosts(const struct message *m)
{
    return topo_is_host(&m->proto->topo, m->from) || topo_is_host(&m->proto->topo, m->to);
}

static vtime link_time(const struct message *m)
{
    return is_hosts(m) ? m->proto->cfg->host.link_ps : 0;
}

vtime proto_trip(const struct message *m)
{
    return link_time(m) + hops_time(m, m->proto->cfg->long_hop_ps);
}

bool proto_one_trip(const struct proto *p, int64_t type, size_t bytes)
{
    return bytes <= p->cfg->short_limit || (type & PROTO_FORCED);
}

/* --- which messages are under way --- */

void proto_link(struct proto *p, struct message *m)
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

void proto_unlink_in(struct message *m)
{
    if (!m->link_in)
        return;
    if (m->next_in)
        m->next_in->link_in = m->link_in;
    *m->link_in = m->next_in;
    m->link_in = NULL;
    m->proto->under_way--;
}

void proto_unlink_out(struct message *m)
{
    if (!m->link_out)
        return;
    if (m->next_out)
        m->next_out->link_out = m->link_out;
    *m->link_out = m->next_out;
    m->link_out = NULL;
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
    struct payload *p = malloc(sizeof *p + bytes);
    if (!p)
        abort();
    p->users = 0;
    if (data)
        memcpy(p->bytes, data, bytes);
    return p->bytes;
}

static void release(struct message *m)
{
    if (m->data != m->few && --payload_of(m->data)->users == 0)
        free(payload_of(m->data));
}

struct message *proto_message_new(struct proto *p, uint32_t from, uint32_t to, int64_t type, int64_t pid,
                                  void *payload, size_t bytes)
{
    struct message *m = pool_take(&p->messages);
    memset(m, 0, offsetof(struct message, few));
    m->data = payload ? payload : m->few;
    if (payload)
        payload_of(payload)->users++;
    m->proto = p, m->from = m->source = from, m->to = to, m->type = type, m->pid = pid, m->bytes = bytes;
    m->is_long = !proto_one_trip(p, type, bytes);
    m->forced = (type & PROTO_FORCED) != 0;
    m->order = p->sent++;
    m->complete = VT_NEVER;
    const struct cfg_machine *c = p->cfg;
    bool small = bytes <= c->short_limit;
    m->transit.from = from, m->transit.to = to;
    vtime hops = link_time(m) + hops_time(m, small ? c->short_hop_ps : c->long_hop_ps);
    vtime per_byte = is_hosts(m) ? c->host.link_ps_per_byte
                     : small     ? c->short_ps_per_byte
                                 : c->long_ps_per_byte;
    m->transit.duration = hops + bytes * per_byte;
    m->transit.holds = c->channel_ps_per_byte ? hops + bytes * c->channel_ps_per_byte : 0;
    return m;
}

struct message *proto_message(struct proto *p, uint32_t from, uint32_t to, int64_t type, int64_t pid,
                              const void *data, size_t bytes)
{
    void *payload = bytes > PROTO_FEW ? proto_payload(data, bytes) : NULL;
    struct message *m = proto_message_new(p, from, to, type, pid, payload, bytes);
    if (!payload && data)
        memcpy(m->few, data, bytes);
    return m;
}

void proto_message_free(struct message *m)
{
    proto_unlink_in(m);
    proto_unlink_out(m);
    release(m);
    pool_give(&m->proto->messages, m);
}
