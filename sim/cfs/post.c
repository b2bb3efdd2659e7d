/* post.c - see post.h. */
#include "cfs/post.h"

/* Message types: of those reserved (nx.h), with and without the forcing bit. */
#define RENDEZVOUS_TYPE INT32_C(1000000001)
#define EAGER_TYPE (INT32_C(2000000000) | PROTOCOL_FORCED)

static int32_t type_of(enum post_kind kind)
{
    return kind == POST_EAGER ? EAGER_TYPE : RENDEZVOUS_TYPE;
}

vtime post_send_time(const struct protocol *p, enum post_kind kind, size_t bytes)
{
    return protocol_send_time(p, type_of(kind), bytes);
}

void post_send(struct protocol *p, uint32_t from, uint32_t to, enum post_kind kind, size_t bytes,
               struct parcel *parcel, vtime at)
{
    struct message *m = protocol_message(p, from, to, type_of(kind), 0, NULL, bytes);
    m->service = parcel;
    m->serves = true;
    protocol_send(p, m, at);
}

bool post_envelope(struct message *m, vtime now)
{
    struct parcel *p = m->service;
    return !m->is_long || !p->has_room || p->has_room(p, m, now);
}

void post_arrived(struct message *m, vtime now)
{
    struct parcel *p = m->service;
    vtime at = m->complete;
    protocol_message_free(m);
    p->arrived(p, at, now);
}
