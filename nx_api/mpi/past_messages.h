/* past_messages.h - messages that this node had and has not any more, for reports of deadlocks: of these
 * a receive may be in want. The last of those that a receive took which may have been meant for another,
 * and of those that were thrown away.
 *
 * Noted is what a receive takes that selects several types, or has a handler, or selects any sender in a
 * program that also names senders. What others take is meant for them. */
#ifndef MPI_PAST_MESSAGES_H
#define MPI_PAST_MESSAGES_H
#include "backend_node.h"
#include "nx_api/waitfor/waitfor.h"

struct past_item {
    enum waitfor_fate fate;
    long type, from, pid;
    size_t bytes;
    struct selector by; /* all -1: no receive */
    const char *call;   /* NULL: not known */
    uintptr_t place;    /* in the program, behind the call, or at the begin of the handler; 0: not known */
};

/* Call when a receive is made. */
static inline void past_receive(struct node *n, const struct receive *r)
{
    n->names_senders |= r->select.node >= 0;
}
/* May a message that r takes have been meant for another receive? */
static inline bool past_matters(const struct node *n, const struct receive *r)
{
    return r->select.type < 0 || r->handler || (n->names_senders && r->select.node < 0);
}
/* Then: the program takes r's message, in a call or as its handler. */
void past_taken(const struct node *n, const struct receive *r);
/* A message is thrown away. */
void past_lost(enum waitfor_fate fate, const struct message *m);
/* The i-th of all that are kept; NULL: there are no more. */
const struct past_item *past_at(unsigned i);
#endif
