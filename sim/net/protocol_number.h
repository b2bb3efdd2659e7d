/* protocol_number.h - numbers of messages, for schedules (doc/schedule-format.md): which message of its
 * sender a message is, and which of those to its receiver. Only in runs that are recorded, or keep orders,
 * messages have room for them. replay/numbering.h assigns them. */
#ifndef NET_PROTOCOL_NUMBER_H
#define NET_PROTOCOL_NUMBER_H
#include "net/protocol.h"

struct message_number {
    uint64_t
        index;    /* among those that its sender's program has sent; all of a message to all nodes have one */
    uint64_t nth; /* among those to its receiver; both count from 0 */
    vtime sent;   /* its sender's processor was done with it then */
    vtime came;   /* its envelope has come to its receiver; VT_NEVER: it has not */
};

/* From now on messages have numbers. Call before any message is made. */
void protocol_number(struct protocol *p);
struct message_number *protocol_number_of(const struct message *m);
/* The first message that the receiver of m is to forward, which is under way; NULL: none. Others follow by
 * next. */
struct message *protocol_forwards(const struct message *m);
#endif
