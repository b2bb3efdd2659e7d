/* message.h - what NX's calls do with a node's messages: receives, sends, handlers, and what a receive
 * selects.
 *
 * Each back end has queues of its own behind the functions declared here: sim/os/mailbox.c,
 * nx_api/mpi/mpi_mailbox.c. The rules by which both choose a message are in matching.h.
 *
 * A receive's buffer is the library's until crecv, msgwait or msgdone has told the end, or the handler runs.
 * The simulator puts the bytes there then, and not before; on MPI they may come there at any time.
 */
#ifndef CONTRACT_MESSAGE_H
#define CONTRACT_MESSAGE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct node;
struct message;

/* param is what hrecvx or hsendx was given. Handlers of the other calls take four arguments, and ignore
 * it. */
typedef void mailbox_handler(long type, long count, long node, long pid, long param);

/* What infocount(), infonode(), infopid() and infotype() answer. */
struct node_info {
    long type, count, node, pid;
};

/* The last error of an NX call. Plain calls end the process with the text; calls with an underscore set errno
 * to the code. */
struct node_error {
    int code; /* of nxerrno.h, or of errno.h */
    char text[256];
};

/* What a receive or probe selects: a typesel as in nx.h; a sending node and its process type, or -1: any. */
struct selector {
    int64_t type;
    long node, pid;
};

/* A receive, from its posting to its completion. */
struct receive {
    struct selector select;
    struct receive *next; /* posted */
    struct message *m;    /* NULL: no message has been selected yet */
    union {
        uint64_t complete; /* simulator: the virtual time from which m, if it has arrived, is complete */
        uint64_t number;   /* MPI: of the node's receives, if the run is recorded */
    };
    uintptr_t place;          /* MPI, for reports: in the program, behind the call; 0: not known */
    mailbox_handler *handler; /* of hrecv; NULL: none */
    void *buf;
    size_t room;                       /* bytes of buf */
    long *info;                        /* the program's array; NULL: none */
    long param;                        /* the handler's */
    struct numbered_receive *numbered; /* simulator: in runs that are recorded, or keep orders */
};

/* Posted receives, in the order of posting. */
struct posted {
    struct receive *first, **end;
};

/* A send, from the call until its buffer may be used again. */
struct send {
    bool done;
    mailbox_handler *handler; /* of hsend; NULL: none */
    long param;               /* the handler's */
    struct node_info info;
    struct message *m; /* while not done */
};

/* The receives and sends of blocking calls. They do not lie on the program's stack, which other threads may
 * not write to. */
struct own_calls {
    struct receive in_handler; /* of a call in a handler; outside of handlers: node.receive */
    struct send send[2];       /* outside of handlers, and in one */
};

/* Types reserved for the library's own messages, of which programs see nothing. */
static inline bool mailbox_is_library(int64_t type)
{
    enum { FIRST_RESERVED = 1000000000, FORCED = 1 << 30 };
    return type >= FIRST_RESERVED && type < FORCED;
}

/* Does typesel (nx.h) select type? The library's own messages are selected by their exact type only. */
static inline bool mailbox_selects(int64_t typesel, int64_t type)
{
    if (typesel >= 0)
        return typesel == type;
    if (mailbox_is_library(type))
        return false;
    if (typesel == -1)
        return true;
    return typesel >> (type < 30 ? type : 30) & 1;
}

/* Select an unexpected message for r, or post r. */
void mailbox_post(struct node *n, struct receive *r);
/* Withdraw a receive whose message no call has taken. A message already selected becomes unexpected again,
 * the first in order; then true is returned, and when all are withdrawn that are to be, the posted receives
 * are to be served: one may select that message. */
bool mailbox_withdraw(struct node *n, struct receive *r);
void mailbox_serve_posted(struct node *n);
/* Has r's message come whole? */
bool mailbox_complete(struct node *n, const struct receive *r);
/* Put a complete message into the program's buffer: spends the time of copying, sets n->info, frees the
 * message. Returns 0, or -1 with n->error when the message is longer than the buffer: then the message is
 * lost, and the buffer unchanged. */
long mailbox_take(struct node *n, struct receive *r);
/* The first complete unexpected message selected; NULL: none. A receive with the same selector would take
 * it. */
const struct message *mailbox_probe(struct node *n, const struct selector *select);
/* The end of a receive that no call will take: frees its message, if that has come whole. */
void mailbox_drop(struct receive *r);
/* Ends the link between s, which is about to be freed, and its message. */
void mailbox_unfollow(struct send *s);

/* Handlers: *r is copied; the send returned is freed behind its handler. */
void mailbox_post_handler(struct node *n, const struct receive *r);
struct send *mailbox_send_handler(struct node *n, mailbox_handler *handler, long param);
#endif
