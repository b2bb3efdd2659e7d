/* mailbox.h - what the calls do with a node's messages: receives posted, messages come in unexpected, ids, handlers. Each
 * backend has a mailbox of its own behind it (sim/os/mailbox.c, nx_api/mpi/mailbox.c); ids are the same (mailbox_ids.c).
 *
 * A message's bytes are put into the program's buffer when the program asks (crecv, msgwait, msgdone, handler), not
 * before: a program that looks too early finds its old bytes, on every backend.
 */
#ifndef CALLS_MAILBOX_H
#define CALLS_MAILBOX_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct node;
struct message;

/* param is what hrecvx or hsendx was given; the other handlers have no such parameter, and do not look. */
typedef void mailbox_handler(long type, long count, long node, long pid, long param);

/* What infocount() and its kin answer. */
struct node_info {
    long type, count, node, pid;
};

/* What a receive or probe selects: types as in nx.h; a sending node and its process type, or -1: any. */
struct selector {
    int64_t type;
    long node, pid;
};

/* A receive, from its posting to its completion. */
struct receive {
    struct selector select;
    struct receive *next;     /* posted */
    struct message *m;        /* NULL until one is selected */
    uint64_t complete;        /* m, from this virtual time on, if it has arrived: the simulator's */
    mailbox_handler *handler; /* hrecv, else NULL */
    void *buf;
    size_t room;
    long *info; /* the program's, NULL: not wanted */
    long param; /* the handler's */
};

/* A send, from the call to the buffer being free again. */
struct send {
    bool done;
    mailbox_handler *handler; /* hsend, else NULL */
    long param;               /* the handler's */
    struct node_info info;
    struct message *m; /* while not done */
};

/* What blocking calls are about: not on the program's stack, which others may not write to. */
struct own_calls {
    struct receive in_handler; /* outside of handlers: node.receive */
    struct send send[2];       /* outside and in handlers */
};

/* Are messages of this type the library's own, which are none of the program's business? */
static inline bool mailbox_is_library(int64_t type)
{
    enum { FIRST_RESERVED = 1000000000, FORCED = 1 << 30 };
    return type >= FIRST_RESERVED && type < FORCED;
}

/* Does typesel select type? (nx.h) The library's own messages are selected by their type only. */
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

/* Select an unexpected message for r, or post it. */
void mailbox_post(struct node *n, struct receive *r);
/* Withdraw a receive that is not complete; a message already selected goes back to the unexpected. */
void mailbox_withdraw(struct node *n, struct receive *r);
bool mailbox_complete(struct node *n, const struct receive *r);
/* Put a complete message into the program's buffer: spends the copying, tells of the message, frees it. 0, or -1 with
 * n->error when it is longer than the buffer: then it is lost, and the buffer is as it was. */
long mailbox_take(struct node *n, struct receive *r);
/* Sets n->info and, if not NULL, the program's info array: type, length, node and process type; four more are reserved. */
void mailbox_tell(struct node *n, const struct message *m, long info[]);
/* The first complete unexpected message selected, NULL if none. */
const struct message *mailbox_probe(struct node *n, const struct selector *select);
/* The end of a receive that nobody will take: frees its message, if it has one that has come whole. */
void mailbox_drop(struct receive *r);
/* The message that s follows shall tell it no more: s is about to be freed. */
void mailbox_unfollow(struct send *s);

/* Message ids, 1 or more. An id stands for a receive, a send, or both; ids that have been merged are parts of the first,
 * which goes on standing for all of them. */
enum { ID_RECEIVES = 1, ID_SENDS = 2 };
long mailbox_id_new(struct node *n, unsigned use);           /* -1: all are taken */
bool mailbox_id_is_valid(const struct node *n, long id);     /* in use, and neither a part nor ignored */
long mailbox_id_next(const struct node *n, long id);         /* the next of its parts, -1: no more */
struct receive *mailbox_id_receive(struct node *n, long id); /* NULL: it has none */
struct send *mailbox_id_send(struct node *n, long id);
bool mailbox_id_is_complete(struct node *n, long id); /* with all its parts */
void mailbox_id_release(struct node *n, long id);     /* and its parts */
void mailbox_id_merge(struct node *n, long id, long part);
void mailbox_id_ignore(struct node *n, long id);
/* Puts the messages of ignored ids that are complete into their buffers, and releases the ids. An error ends the
 * process: nobody asks for the id any more. */
void mailbox_settle(struct node *n);

/* Handlers. */
void mailbox_post_handler(struct node *n, const struct receive *r);
struct send *mailbox_send_handler(struct node *n, mailbox_handler *handler, long param);
#endif
