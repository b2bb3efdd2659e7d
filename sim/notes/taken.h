/* taken.h - messages that a node had and has not any more, for reports of deadlocks: those that a receive
 * took and that may have been meant for another, and those that were thrown away. The latest few of both. An
 * observer (os/observer.h) notes them.
 *
 * Noted is what a receive takes that selects several types, or has a handler, or selects any sender in a
 * program that also names senders. What others take is meant for them, and noting it would cost time. */
#ifndef NOTES_TAKEN_H
#define NOTES_TAKEN_H
#include "net/protocol.h"
#include "node/node.h"

enum taken_how { TAKEN_BY_RECEIVE, TAKEN_BY_HANDLER, TAKEN_BY_FLUSH, TAKEN_AS_FORCED };
/* So many are kept, and so many calls of each: MPI's library may have five of its own in the program's. */
enum { TAKEN_MOST = 8, TAKEN_CALLS = 8 };

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

/* The node's program has been loaded; is gone. */
void taken_begin(struct node *n);
void taken_end(struct node *n);
/* NULL: nothing has been noted. */
const struct taken_log *taken_of(const struct node *n);
/* The k-th of those kept, the oldest first; NULL: there are no more. */
const struct taken *taken_get(const struct taken_ring *r, uint32_t k);
#endif
