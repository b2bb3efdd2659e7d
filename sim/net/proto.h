/* proto.h - the message protocol of NX: how a message gets from one node's memory into another's.
 *
 *   short (at most short_limit bytes)      sender ---- message ----> receiver     one trip
 *   forced (bit 30 of the type)            the same at any length, at times of its own (forced_send, forced_receive);
 *                                          dropped when nothing is posted
 *   long                                   sender ------ ask ------> receiver     room found, or waited for
 *                                          sender <----- grant ----- receiver
 *                                          sender ------ data -----> receiver     three trips
 *
 * Asking and granting are a few bytes: they take their hops' time, but no channel. Messages and data hold channels
 * (wire.h). Each trip takes processor time at both ends (machine file: system); the processor also feeds and empties
 * the channel of long messages byte by byte where the machine has no DMA (send_us_per_byte, receive_us_per_byte).
 * Envelopes (short messages, asks) between two nodes are looked at in the order sent.
 *
 * To all nodes: along a spanning tree. The sender has all the nodes to reach; it sends to the first of the upper part
 * and leaves that part to it, and goes on with the lower part, until it is alone. With 8 nodes and node 0 sending, the
 * three steps are as below; otherwise node numbers are counted from the sender, by exclusive or when they are a power of
 * two, so that on a hypercube each message goes to a neighbour.
 *
 *     0 ----------------------> 4            1st
 *     0 ---------> 2            4 --> 6      2nd
 *     0 -> 1       2 -> 3       4 -> 5  6 -> 7   3rd
 *
 * The host sends to node 0 only, which is then the root of the tree; a node's message to all does not go to the host.
 * A node's operating system passes a message on, whether its program has asked for it or not, before it gives it to the
 * program. That NX takes log2 N steps is known; where in the kernel a message is passed on, and the order, are open.
 *
 * The protocol knows nodes only through struct proto_nodes.
 */
#ifndef PROTO_PROTO_H
#define PROTO_PROTO_H
#include "config/config.h"
#include "net/wire.h"

struct proto;

#define PROTO_FORCED INT32_C(0x40000000)

struct trip; /* of a message that is under way: proto_parts.h */

/* A message from its making until it has been received. Thousands may lie unexpected in mailboxes: so it has no more than is
 * of use then, and what a receiver looks at first in the first line of the cache. */
struct message {
    struct message *next; /* of those sent in one call; of those to be passed on; then of the unexpected */
    int32_t type, pid;
    uint32_t from, to;
    uint32_t source; /* whose program sent it: from, unless it has been passed on */
    bool is_long : 1, forced : 1;
    bool serves : 1;   /* service is set */
    bool followed : 1; /* send is set */
    bool granted : 1;
    bool arrived : 1;
    bool buffered : 1; /* held in a system buffer */
    bool unwanted : 1; /* to be thrown away when it arrives */
    bool too_long : 1; /* for its receiver's buffer */
    bool whole : 1;    /* unexpected, and in the order of the whole: os/unexpected.h */
    size_t bytes;
    union {
        uint64_t order; /* of the source's messages, until it is sent */
        vtime complete; /* arrived: all in the receiver's memory, from then on */
    };
    void *receive;     /* the posted receive it is for, NULL: none yet */
    struct trip *trip; /* NULL: not sent yet, or arrived */

    union {
        void *send;                  /* the sender's message id or handler, if anybody asks */
        struct message **whole_link; /* whole: what points to it */
    };
    void *service; /* not between programs: what it is about, to a service or its client */
    struct proto *proto;
    void *data; /* a copy of the sender's: in few, or shared by messages to all nodes */
    char few[];
};

/* At which end of a message a processor has something to do. */
enum proto_task { PROTO_SEND, PROTO_RECEIVE };

struct proto_nodes {
    void *ctx;
    /* The operating system of a node works for t, from `at` on or when it is free; returns when it has
     * finished. */
    vtime (*work)(void *ctx, uint32_t node, enum proto_task task, vtime at, vtime t);
    /* The processor of a node moves bytes for t in all, from `at` on. That is interrupted by the work above and does not
     * hold it up: both directions of an exchange go on at once. */
    void (*move)(void *ctx, uint32_t node, enum proto_task task, vtime at, vtime t);
    /* An envelope has come: match it with a receive, or find a buffer. False: no room yet; proto_grant()
     * later. For a forced message with nothing posted return false too: it is dropped and freed. */
    bool (*envelope)(void *ctx, struct message *m, vtime now);
    /* The buffer of one that is followed may be used again. */
    void (*sent)(void *ctx, struct message *m, vtime now);
    void (*arrived)(void *ctx, struct message *m, vtime now); /* m->complete is set */
};

struct proto *proto_new(const struct cfg_machine *cfg, const struct topo *topo, struct evq *q,
                        const struct proto_nodes *nodes);
void proto_free(struct proto *p);

/* Is it sent without asking? Then the sender's buffer is free when the message has left. */
bool proto_one_trip(const struct proto *p, int32_t type, size_t bytes);
/* Processor time the sender's call spends before the message leaves. */
vtime proto_send_time(const struct proto *p, int32_t type, size_t bytes);
/* A message; data are copied. The caller hands it to proto_send at the time its processor is done with it. */
struct message *proto_message(struct proto *p, uint32_t from, uint32_t to, int32_t type, int32_t pid,
                              const void *data, size_t bytes);
void proto_send(struct proto *p, struct message *m, vtime at);
/* The sender's program has been ended at an earlier time than `at`. */
void proto_take_back(struct message *m);
/* The messages that the sender itself sends to reach all other nodes, in order, linked by `next`; each to be handed to
 * proto_send. NULL if there is no other node. */
struct message *proto_to_all(struct proto *p, uint32_t from, int32_t type, int32_t pid, const void *data,
                             size_t bytes);
/* From now on all nodes are the first n of the cube. Not more than it was made for. */
void proto_set_nodes(struct proto *p, uint32_t n);
/* The messages on their way to a place, and those being sent from there: the first, and the one after m. NULL: no more. */
struct message *proto_to(const struct proto *p, uint32_t place);
struct message *proto_next_to(const struct message *m);
struct message *proto_from(const struct proto *p, uint32_t place);
struct message *proto_next_from(const struct message *m);
/* Room has been found for a message whose envelope was answered with false. */
void proto_grant(struct proto *p, struct message *m, vtime now);
/* The receiver is done with it, or it is not wanted. */
void proto_message_free(struct message *m);
/* Is it one that has arrived, with few bytes, all in itself? Then it can be freed without a look at it. */
bool proto_message_is_plain(const struct message *m);
void proto_message_free_plain(struct proto *p, struct message *m);

/* The earliest time at which anything may reach a node, given that nothing at all happens before `next`. */
vtime proto_horizon(const struct proto *p, uint32_t node, vtime next);
/* Messages under way or not yet fetched. */
uint64_t proto_under_way(const struct proto *p);
const struct wire *proto_wire(const struct proto *p);
#endif
