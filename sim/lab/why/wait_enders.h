/* wait_enders.h - the messages that ended waits. */
#ifndef LAB_WHY_WAIT_ENDERS_H
#define LAB_WHY_WAIT_ENDERS_H
#include "lab/why/piece_map.h"

/* A wait ends by a message's arrival at the waiting node, or because a message of that node has left. */
struct wait_ender {
    int32_t message; /* TRACE_NONE: none is known */
    int32_t handler; /* that the message made due, and that began when the wait ended; TRACE_NONE */
    bool leaves;     /* the message is the waiting node's own, which has left */
    vtime at;        /* when it had arrived, or left */
};

struct wait_enders {
    const struct trace *t;
    /* Messages by their receiver, then the time at which they are complete; and by their sender, then the
     * time at which the sender's buffer is free. */
    int32_t *arriving, *leaving;
};

/* The trace must outlive them. */
struct wait_enders wait_enders_new(const struct trace *t);
void wait_enders_free(struct wait_enders *e);

/* What ended a wait. */
struct wait_ender wait_enders_of(const struct wait_enders *e, const struct piece_map *map, int32_t wait);
/* The message that a node's system forwarded as m; TRACE_NONE: m was sent by a program's call. */
int32_t wait_enders_forwarded(const struct wait_enders *e, int32_t m);

/* When the sender's buffer of a message is free: VT_NEVER if it never was. */
static inline vtime message_leaves(const struct trace_message *m)
{
    return m->is_long ? m->left : m->entered;
}
#endif
