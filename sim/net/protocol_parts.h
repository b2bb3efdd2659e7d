/* protocol_parts.h - what the files of the protocol share: protocol.c (the trips), protocol_message.c
 * (messages, and the lists of those under way), protocol_tree.c (messages to all nodes). For these files
 * only. */
#ifndef NET_PROTOCOL_PARTS_H
#define NET_PROTOCOL_PARTS_H
#include <stddef.h>
#include "kernel/arena.h"
#include "net/endpoint.h"
#include "net/movers.h"
#include "trace/trace_format.h"

/* A lower bound on when a message next affects a node: not before `at`, nor before the machine's next event
 * plus `after`. Lets a node with an armed handler compute on until then. */
struct protocol_bound {
    vtime at, after;
};

enum trip_kind {
    TRIP_SHORT,  /* the others: programmed I/O at both ends, where the machine has no DMA */
    TRIP_FORCED, /* longer, and eager all the same */
    TRIP_LONG    /* rendezvous */
};

/* Of a message's envelope. */
enum trip_envelope {
    TRIP_COMING,
    TRIP_WAITS, /* it has come before an earlier one's */
    TRIP_SEEN   /* the receiver has handled it, or nobody waits for it */
};

/* The part of a message that exists only under way. The messages of a tree are under way from their making,
 * others from when they are sent; all until they have arrived. */
struct trip {
    struct message *m;
    struct trip *next_in, **link_in;   /* to the receiver */
    struct trip *next_out, **link_out; /* being sent by the sender, which may yet hear of it */
    uint64_t order;                    /* the message's, as source */
    uint32_t source;
    enum trip_envelope envelope : 8;
    enum trip_kind kind : 8;
    bool taken_back;         /* the sender has ended before the message left */
    bool followed;           /* the message was so when it was sent */
    struct message *forward; /* the messages that the receiver is to send on */

    struct protocol_bound at_sender, at_receiver;
    struct channel_transit transit;
};
_Static_assert(offsetof(struct trip, transit.next) == 128,
               "a trip that waits for no channel takes two lines");

/* So many bytes lie in the message itself at most: hardly any, or as many as the machines' short messages
 * have. */
enum protocol_size { PROTOCOL_FEW, PROTOCOL_SHORT, PROTOCOL_SIZES };
static const size_t PROTOCOL_IN_MESSAGE[PROTOCOL_SIZES] = {32, 160};
_Static_assert(sizeof(struct message) == 96 && offsetof(struct message, send) == 64,
               "a message with few bytes takes two lines of the cache");

/* What lives at one address: the messages on their way to it and those being sent by it. */
struct protocol_endpoint {
    struct trip *in, *out;
    uint64_t made;        /* messages, by the endpoint */
    uint32_t coming;      /* the length of `in` */
    uint32_t waiting;     /* of them: those that wait, because an envelope sent earlier has not come */
    struct queues *flows; /* those of `in` whose envelope has not come, by source; NULL: there are few */
};

struct recorder;

struct protocol {
    struct recorder *recorder; /* NULL: none */
    const struct cfg_machine *cfg;
    struct topo topo;
    struct evq *q;
    struct channels *channels;
    struct movers *movers; /* NULL: a processor moves any number of messages at once */
    void *ends;            /* endpoint.h */
    struct protocol_endpoint *endpoints;
    struct arena messages[PROTOCOL_SIZES], trips;
    uint64_t under_way;
    /* The quickest node's system takes so many thousandths of the time that an ordinary node's takes. */
    uint64_t least_milli;
};

/* The least time that any node's system takes for work that takes an ordinary node's system the time t. */
static inline vtime protocol_least(const struct protocol *p, vtime t)
{
    return p->least_milli == 1000 ? t : t * p->least_milli / 1000;
}

/* The least time in which any node's system sends anything. */
static inline vtime protocol_least_send_time(const struct protocol *p)
{
    const struct cfg_machine *c = p->cfg;
    return protocol_least(p, vt_min(c->short_send_ps, vt_min(c->forced_send_ps, c->ask_send_ps)));
}

static const struct protocol_bound PROTOCOL_NOTHING = {.at = VT_NEVER};

static inline struct protocol_bound protocol_at(vtime t)
{
    return (struct protocol_bound){.at = t};
}

static inline struct protocol_bound protocol_after(vtime t)
{
    return (struct protocol_bound){.after = t};
}

/* Time of a few bytes, or of a long message's first byte, over the hops. */
vtime protocol_latency(const struct protocol *p, const struct message *m);

/* A copy of bytes, for messages to share; NULL if data is NULL, as for messages whose bytes nobody reads. */
void *protocol_payload(const void *data, size_t bytes);
/* A message whose data are of protocol_payload, which has one more user then, or NULL. */
struct message *protocol_message_sharing(struct protocol *p, uint32_t from, uint32_t to, int32_t type,
                                         int32_t pid, void *payload, size_t bytes);
/* Where a message's memory is from. */
struct arena *protocol_pool_of(const struct message *m);
/* The message's trip begins; is on its way to the receiver; the sender may yet hear of it. */
void protocol_begin_trip(struct protocol *p, struct message *m);
void protocol_link_in(struct protocol *p, struct trip *t);
void protocol_link_out(struct protocol *p, struct trip *t);
/* The receiver has handled the envelope, or nobody waits for it. */
void protocol_envelope_seen(struct protocol *p, struct trip *t);
/* Of the messages on their way from the program at source, the first whose envelope has not come. NULL: there
 * is none. */
struct trip *protocol_first_coming(const struct protocol *p, uint32_t source, uint32_t to);
/* The message has left. */
void protocol_unlink_out(struct trip *t);
/* The message has arrived, or is freed: the trip is over. */
void protocol_end_trip(struct protocol *p, struct message *m);

/* --- the record: protocol_record.c --- */

/* Notes a time of enum message_time (trace/trace_format.h), or that the message was sent: MESSAGE_TIMES. */
void protocol_note_time(struct trip *t, int which, vtime when);
static inline void protocol_note(const struct protocol *p, struct trip *t, int which, vtime when)
{
    if (__builtin_expect(p->recorder != NULL, 0))
        protocol_note_time(t, which, when);
}
void protocol_note_begin(struct trip *t);
void protocol_note_end(struct protocol *p, struct trip *t);

/* --- trips: protocol_trip.c --- */

/* An event: a message, or its data (arg: the trip), enter the network. */
void protocol_inject(void *ctx, void *arg, vtime now);
/* What the movers tell: the processors at both ends are free to move the message. */
void protocol_places_found(void *ctx, struct channel_transit *t, vtime now);
/* What the channels tell: the head has come, the tail has passed. */
void protocol_trip_started(void *ctx, struct channel_transit *t, vtime now);
void protocol_trip_done(void *ctx, struct channel_transit *t, vtime now);
/* protocol.c: a message, or its data, has arrived. */
void protocol_trip_ends(struct protocol *p, struct message *m, vtime now);
#endif
