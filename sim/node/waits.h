/* waits.h - where a node's idle time went: a small table, an entry for each call and message type it has
 * waited in. */
#ifndef NODE_WAITS_H
#define NODE_WAITS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "kernel/vtime.h"

struct node_wait {
    const char *call;
    bool has_type; /* otherwise it waited for no message: type is 0 */
    long type;     /* of the message waited for: a type, or the typesel given */
    vtime idle;
    uint64_t waits;
};

struct node_waits {
    struct node_wait *list;
    uint32_t count, room;
};

/* One more wait, of `idle`. call's text must stay. */
void waits_add(struct node_waits *w, const char *call, bool has_type, long type, vtime idle);
void waits_free(struct node_waits *w);
#endif
