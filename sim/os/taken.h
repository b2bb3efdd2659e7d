/* taken.h - messages that a node had and has not any more, for reports of deadlocks: those that a receive
 * took and that may have been meant for another, and those that were thrown away. The latest few of both.
 *
 * Noted is what a receive takes that selects several types, or has a handler, or selects any sender in a
 * program that also names senders. What others take is meant for them, and noting it would cost time. */
#ifndef OS_TAKEN_H
#define OS_TAKEN_H
#include "net/protocol.h"
#include "node/node.h"

enum taken_how { TAKEN_BY_RECEIVE, TAKEN_BY_HANDLER, TAKEN_BY_FLUSH, TAKEN_AS_FORCED };
enum { TAKEN_MOST = 8, TAKEN_CALLS = 4 };

struct taken {
    enum taken_how how;
    struct selector by; /* the receive's; all -1 of a message thrown away */
    const char *call;   /* that took it; NULL: none did */
    uintptr_t
        at[TAKEN_CALLS]; /* return addresses in the program, the innermost first; 0: no more. Of a handler
                              * its own address */
    int32_t type, pid;
    uint32_t source; /* address of the sender */
    size_t bytes;
    vtime came; /* when it was complete, or, if it never was, thrown away */
};

/* The latest of one kind, a ring. */
struct taken_ring {
    struct taken last[TAKEN_MOST];
    uint32_t count; /* of all */
};

/* By the program, in its order; and thrown away, in the order of events. */
struct taken_log {
    struct taken_ring by_program, lost;
};

/* May a message that r takes have been meant for another receive? */
static inline bool taken_matters(const struct node *n, const struct receive *r)
{
    return r->select.type < 0 || r->handler || (n->names_senders && r->select.node < 0);
}
/* The program takes r's message m, in the call that n is in, or a handler of the program. */
void taken_note(struct node *n, const struct receive *r, const struct message *m);
/* m is thrown away: by flushmsg, or because its type is a forced one and no receive is posted. */
void taken_note_loss(struct node *n, const struct message *m, enum taken_how how, vtime now);
/* The k-th of those kept, the oldest first; NULL: there are no more. */
const struct taken *taken_get(const struct taken_ring *r, uint32_t k);
#endif
