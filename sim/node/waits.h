/* waits.h - a node's idle time by the calls that it waited in: a small table with an entry for each call
 * and message type that the node has waited in. Of very many types the later ones have no entries of their
 * own, but one for the call. */
#ifndef NODE_WAITS_H
#define NODE_WAITS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "kernel/vtime.h"

struct node_wait {
    const char *call;
    bool has_type; /* otherwise the call waits for no message, or for one of many types; and type is 0 */
    long type;     /* of the message waited for, or the typesel of the receive */
    vtime idle;
    uint64_t waits;
};

struct node_waits {
    struct node_wait *list;
    uint32_t count, room;
};

/* Adds a wait of `idle` to its entry. The table keeps `call`, whose text must outlast the table. */
void waits_add(struct node_waits *w, const char *call, bool has_type, long type, vtime idle);
void waits_free(struct node_waits *w);
#endif
