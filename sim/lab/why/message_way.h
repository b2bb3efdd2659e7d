/* message_way.h - the way of a message, backwards: from the receiver, or from the moment at which it has
 * left, to the call that sent it; in legs, each of one class.
 *
 *     complete   <- WHY_MESSAGE   the receiver's system takes it; WHY_OTHER_MESSAGES if it was busy before
 *     left       <- WHY_NETWORK   its bytes are on their way
 *     moved      <- WHY_CHANNEL   waiting for channels; WHY_NETWORK between two waits
 *     entered    <- WHY_MESSAGE   long messages: the sender's system takes the clear to send
 *                <- WHY_NETWORK   the clear to send is on its way
 *     granted    <- WHY_GRANT     the receiver has no receive posted, and no room; or else
 *                   WHY_MESSAGE   the receiver's system answers the request
 *     asked      <- WHY_NETWORK   the request is on its way
 *     sent          by a call; or by the system of a node that forwards another: that one's way follows
 *
 * The legs fill the time from `sent` on without gap. */
#ifndef LAB_WHY_MESSAGE_WAY_H
#define LAB_WHY_MESSAGE_WAY_H
#include "lab/why/wait_enders.h"
#include "lab/why/why_class.h"

struct way_leg {
    vtime begin, end;
    enum why_class class;
    int32_t message; /* of which this is the way: one of those forwarded */
    int32_t node;    /* whose system works, or whose receive is late; TRACE_NONE: the network */
    int32_t block;   /* WHY_CHANNEL: into trace.blocks; else TRACE_NONE */
};

struct message_way {
    struct way_leg *legs; /* the last in time first */
    size_t count, room;
    int32_t message; /* the message that a program's call sent: the first, if it was forwarded */
    int32_t node;    /* which sent it; TRACE_NONE: a service */
    vtime sent;
};

/* Finds the way of a message that had arrived (or, if leaves, had left) at `at`. *way is {0}, or of an
 * earlier way, whose memory is used again; free(way->legs) in the end. */
void message_way_find(const struct wait_enders *e, struct piece_map *map, int32_t message, bool leaves,
                      vtime at, struct message_way *way);
#endif
