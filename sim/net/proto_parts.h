/* proto_parts.h - what the files of the protocol share: proto.c (the trips), proto_message.c (messages and where they
 * are), proto_tree.c (to all nodes). For these files only. */
#ifndef PROTO_PARTS_H
#define PROTO_PARTS_H
#include "kernel/pool.h"
#include "net/proto.h"

struct proto {
    const struct cfg_machine *cfg;
    struct topo topo;
    struct evq *q;
    struct wire *wire;
    struct proto_nodes nodes;
    struct message **in, **out; /* by node: messages on their way to it, being sent by it */
    struct pool messages;
    uint64_t sent, under_way;
    uint64_t
        least_milli; /* no node's system takes less than so many thousandths of the time that an ordinary one's does */
};

/* The least time in which any node's system does what takes an ordinary one's t. */
static inline vtime proto_least(const struct proto *p, vtime t)
{
    return p->least_milli == 1000 ? t : t * p->least_milli / 1000;
}

static const struct proto_bound PROTO_NOTHING = {.at = VT_NEVER};

static inline struct proto_bound proto_at(vtime t)
{
    return (struct proto_bound){.at = t};
}

static inline struct proto_bound proto_after(vtime t)
{
    return (struct proto_bound){.after = t};
}

/* Time of one trip of a long message over the hops alone. */
vtime proto_trip(const struct message *m);

/* A copy of bytes, for messages to share; NULL: nobody looks at them. */
void *proto_payload(const void *data, size_t bytes);
/* payload: of proto_payload, one more user; NULL: few bytes, to be filled in. */
struct message *proto_message_new(struct proto *p, uint32_t from, uint32_t to, int64_t type, int64_t pid,
                                  void *payload, size_t bytes);
/* Under way to its receiver and being sent by its sender, from now on; and no more. */
void proto_link(struct proto *p, struct message *m);
void proto_unlink_in(struct message *m);
void proto_unlink_out(struct message *m);
#endif
