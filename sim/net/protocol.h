/* protocol.h - the message protocol of NX: how a message gets from one node's memory into another's.
 *
 *   short (at most short_limit bytes)    sender ------- message ------> receiver    eager: one trip
 *   forced (bit 30 of the type)          as short, at any length, with processor times of its own
 *                                        (forced_send, forced_receive); dropped if no receive is posted
 *   long                                 sender --- request to send --> receiver    finds or awaits room
 *                                        sender <--- clear to send ---- receiver
 *                                        sender -------- data --------> receiver    rendezvous: three trips
 *
 * A request to send and a clear to send are a few bytes: they take their hops' time, but no channel. Messages
 * and data hold channels (channel.h). Each trip takes processor time at both ends (machine file: system,
 * where a request to send is called ask and a clear to send is called grant). Where the machine has no DMA,
 * the processors also move the bytes of a message longer than short_limit into and out of the channel:
 * programmed I/O (send_us_per_byte, receive_us_per_byte). A receiver handles the envelopes (short messages,
 * requests to send) of one sender in the order sent.
 *
 * A message to all nodes goes along a spanning tree. The sender has all the nodes to reach; it sends to the
 * first of the upper part and leaves that part to it, and goes on with the lower part, until it is alone.
 * With 8 nodes and node 0 sending, the three steps are as below; otherwise node numbers are counted from the
 * sender, by exclusive or when they are a power of two, so that on a hypercube each message goes to a
 * neighbour.
 *
 *     0 ----------------------> 4            1st
 *     0 ---------> 2            4 --> 6      2nd
 *     0 -> 1       2 -> 3       4 -> 5  6 -> 7   3rd
 *
 * The host sends to node 0 only, which is then the root of the tree; a node's message to all does not go to
 * the host. A node's operating system forwards a message before it gives the message to the program, whether
 * the program has asked for the message or not. It is known that NX takes log2 N steps; where in the kernel
 * it forwards, and in which order, is open.
 *
 * The protocol knows nodes only through endpoint.h. Addresses are those of topo.h.
 */
#ifndef NET_PROTOCOL_H
#define NET_PROTOCOL_H
#include "config/config.h"
#include "net/channel.h"

struct protocol;

#define PROTOCOL_FORCED INT32_C(0x40000000)

/* What messages carry besides their bytes, for whoever receives them: as the head of a struct of the
 * sender's. end() is called when the last message that carries it is freed. */
struct protocol_cargo {
    uint32_t users;
    void (*end)(struct protocol_cargo *cargo);
};

struct trip; /* the part of a message that exists only under way: protocol_parts.h */

/* A message from its making until the receiver is done with it. Thousands may lie unexpected in mailboxes: so
 * it has no more than is of use then, and the fields that a receiver reads first are in the first line of the
 * cache. */
struct message {
    struct message *next; /* the next sent in one call, or to be forwarded; later: of the unexpected */
    int32_t type, pid;
    uint32_t from, to;
    uint32_t source; /* whose program sent it: from, unless it has been forwarded */
    bool is_long : 1, forced : 1;
    bool serves : 1;   /* service is set */
    bool carries : 1;  /* cargo is set */
    bool followed : 1; /* send is set */
    bool cleared : 1;  /* the clear to send has left the receiver */
    bool arrived : 1;
    bool buffered : 1; /* held in a system buffer */
    bool unwanted : 1; /* to be thrown away when it arrives */
    bool too_long : 1; /* for its receiver's buffer */
    bool whole : 1;    /* unexpected, and in the order of the whole: os/unexpected.h */
    bool in_order : 1; /* MPI's: with the others of its source and pid, it is found in the order sent */
    bool held : 1;     /* MPI's synchronous send: the receiver clears it for a receive, not for room */
    size_t bytes;
    union {
        uint64_t order; /* among the source's messages; until it is sent */
        vtime complete; /* once arrived: when all of it is in the receiver's memory */
    };
    void *receive;     /* the posted receive it is for; NULL: none yet */
    struct trip *trip; /* NULL: not sent yet, or arrived */

    union {
        void *send;                  /* the sender's message id or handler, if anybody asks */
        struct message **whole_link; /* whole: the link that points to it */
    };
    union {
        void *service; /* between a service and its client: what the message is about */
        struct protocol_cargo *cargo;
        uint64_t asked; /* a long message with neither: when its receiver had handled its request to send */
    };
    struct protocol *protocol; /* NULL: freed */
    void *data;                /* a copy of the sender's: in few, or shared by messages to all nodes */
    char few[];
};

/* The protocol between the addresses of a network. `ends` is what endpoint.h's functions are given. */
struct protocol *protocol_new(const struct cfg_machine *cfg, const struct topo *topo, struct evq *q,
                              void *ends);
void protocol_free(struct protocol *p);

/* Is a message of that type and length sent without a request? Then its buffer is free when it has left. */
bool protocol_is_eager(const struct protocol *p, int32_t type, size_t bytes);
/* Processor time that the sender's call spends before the message leaves. */
vtime protocol_send_time(const struct protocol *p, int32_t type, size_t bytes);
/* Makes a message with a copy of the data. The caller owns it, and gives it to protocol_send at the time at
 * which its processor is done with the message. */
struct message *protocol_message(struct protocol *p, uint32_t from, uint32_t to, int32_t type, int32_t pid,
                                 const void *data, size_t bytes);
void protocol_send(struct protocol *p, struct message *m, vtime at);
/* Makes a message that has not been sent one that asks first, however short, and is held. */
void protocol_hold(struct message *m);
/* protocol_send, where the message leaves so much later. Envelopes of one sender are handled in the order
 * sent all the same. */
void protocol_send_late(struct protocol *p, struct message *m, vtime at, vtime late);
/* Withdraws a message that was to leave at a time at which the sender's program has ended already. */
void protocol_take_back(struct message *m);
/* Makes the messages that the sender itself sends to reach all other nodes, in order, linked by `next`; the
 * caller gives each to protocol_send. NULL if there is no other node. */
struct message *protocol_to_all(struct protocol *p, uint32_t from, int32_t type, int32_t pid,
                                const void *data, size_t bytes);
/* The messages that have been made for one call, linked by next, and those that forward them, carry this. */
void protocol_carry(struct message *first, struct protocol_cargo *cargo);
/* From now on "all nodes" are the first n of the cube, at most as many as the protocol was made for. */
void protocol_set_nodes(struct protocol *p, uint32_t n);
/* The messages on their way to an address; and those being sent from there that are followed, or moved by
 * programmed I/O: the first, and the one after m. NULL: no more. */
struct message *protocol_to(const struct protocol *p, uint32_t address);
struct message *protocol_next_to(const struct message *m);
struct message *protocol_from(const struct protocol *p, uint32_t address);
struct message *protocol_next_from(const struct message *m);
/* The receiver has found room for a long message whose envelope it answered with false. Once a message. */
void protocol_clear_to_send(struct protocol *p, struct message *m, vtime now);
/* The receiver is done with the message, or does not want it. Once for each message. */
void protocol_message_free(struct message *m);
/* Has the message arrived, with so few bytes that all of them are in the message itself? Then its memory can
 * be freed without reading it. */
bool protocol_message_is_plain(const struct message *m);
void protocol_message_free_plain(struct protocol *p, struct message *m);

/* A lower bound on the time at which anything can reach a node, given that no event at all happens before
 * `next`. */
vtime protocol_horizon(const struct protocol *p, uint32_t node, vtime next);
/* The number of messages sent that have not arrived. */
uint64_t protocol_under_way(const struct protocol *p);
const struct channels *protocol_channels(const struct protocol *p);
#endif
