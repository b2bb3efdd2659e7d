/* proto_parts.h - what the files of the protocol share: proto.c (the trips), proto_message.c (messages and where they
 * are), proto_tree.c (to all nodes). For these files only. */
#ifndef PROTO_PARTS_H
#define PROTO_PARTS_H
#include <stddef.h>
#include "kernel/arena.h"
#include "net/proto.h"

/* When the next thing reaches a node on a message's account: not before `at`, nor before the machine's next
 * event plus `after`. Lets a node with an armed handler compute on until then. */
struct proto_bound {
    vtime at, after;
};

/* What a message has only while it is under way. A tree's messages are so from their making, others from when they are
 * sent, and all until they have arrived. */
struct trip {
    struct message *m;
    struct trip *next_in, **link_in;   /* to the receiver */
    struct trip *next_out, **link_out; /* being sent by the sender */
    uint64_t order;                    /* the message's, as source */
    uint32_t source;
    bool waits : 1;          /* its envelope has come before an earlier one's */
    bool envelope : 1;       /* has been looked at by the receiver */
    bool taken_back : 1;     /* has not been sent, after all */
    bool is_long : 1;        /* the message */
    bool by_hand : 1;        /* the processors feed and empty its channel, where the machine has no DMA */
    bool followed : 1;       /* the message was so when it was sent */
    struct message *pass_on; /* what the receiver is to send on */

    struct proto_bound at_sender, at_receiver;
    struct wire_transit transit;
};
_Static_assert(offsetof(struct trip, transit.next) == 128,
               "a trip that waits for no channel takes two lines");

/* So few bytes lie in the message itself: hardly any, and those of the short messages of the machines. */
enum proto_size { PROTO_FEW, PROTO_SHORT, PROTO_SIZES };
static const size_t PROTO_IN_MESSAGE[PROTO_SIZES] = {32, 160};
_Static_assert(sizeof(struct message) == 96 && offsetof(struct message, send) == 64,
               "a message with few bytes takes two lines of the cache");

/* Of a node or service: messages on their way to it, being sent by it; how many it has made. */
struct proto_place {
    struct trip *in, *out;
    uint64_t made;
    uint32_t coming;      /* of `in` */
    struct queues *flows; /* those of `in` whose envelope has not come, by source; NULL: there are few */
};

struct proto {
    const struct cfg_machine *cfg;
    struct topo topo;
    struct evq *q;
    struct wire *wire;
    struct proto_nodes nodes;
    struct proto_place *places;
    struct arena messages[PROTO_SIZES], trips;
    uint64_t under_way;
    uint64_t
        least_milli; /* no node's system takes less than so many thousandths of the time that an ordinary one's does */
};

/* The least time in which any node's system does what takes an ordinary one's t. */
static inline vtime proto_least(const struct proto *p, vtime t)
{
    return p->least_milli == 1000 ? t : t * p->least_milli / 1000;
}

/* The least time in which any node's system sends anything. */
static inline vtime proto_least_send_time(const struct proto *p)
{
    const struct cfg_machine *c = p->cfg;
    return proto_least(p, vt_min(c->short_send_ps, vt_min(c->forced_send_ps, c->ask_send_ps)));
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
vtime proto_trip(const struct proto *p, const struct message *m);

/* A copy of bytes, for messages to share; NULL of NULL, which nobody looks at. */
void *proto_payload(const void *data, size_t bytes);
/* Its data are of proto_payload, which has one more user then, or NULL. */
struct message *proto_message_sharing(struct proto *p, uint32_t from, uint32_t to, int32_t type, int32_t pid,
                                      void *payload, size_t bytes);
/* Its trip begins; when it is linked, it is under way to its receiver and being sent by its sender. */
void proto_begin_trip(struct proto *p, struct message *m);
void proto_link(struct proto *p, struct trip *t);
/* Its envelope has been looked at, or nobody waits for it. */
void proto_envelope_seen(struct proto *p, struct trip *t);
/* Of the messages on their way from the program at source, the first whose envelope has not come. NULL: there is none. */
struct trip *proto_first_coming(const struct proto *p, uint32_t source, uint32_t to);
/* It has left; and it has arrived: the trip is over. */
void proto_unlink_out(struct trip *t);
void proto_end_trip(struct proto *p, struct message *m);
#endif
