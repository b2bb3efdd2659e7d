/* mailbox.h - the messages of a node: receives posted, messages come in unexpected, ids, and handlers due.
 *
 *   an envelope comes:  a posted receive selects it  ->  it is that receive's, and goes straight to its buffer
 *                       none does                    ->  it waits, unexpected, in a system buffer
 *   a receive is made:  the first unexpected message it selects, else it is posted (first posted, first served)
 *
 * A message is complete when it has arrived and the operating system is done with it (message.complete). Its
 * bytes are put into the program's buffer when the program asks (crecv, msgwait, msgdone, handler), not
 * before: a program that looks too early finds its old bytes, the same in every run.
 */
#ifndef NODE_MAILBOX_H
#define NODE_MAILBOX_H
#include "net/proto.h"
#include "node/node.h"

typedef void node_handler(long type, long count, long node, long pid);

/* A receive, from its posting to its completion. */
struct receive {
    int64_t typesel;
    void *buf;
    size_t room;
    node_handler *handler; /* hrecv, else NULL */
    struct message *m;     /* NULL until one is selected */
    struct receive *next;  /* posted */
};

/* A send, from the call to the buffer being free again. */
struct send {
    bool done;
    node_handler *handler; /* hsend, else NULL */
    struct node_info info;
    struct message *m; /* while not done */
};

struct mailbox *mailbox_new(uint32_t ids);
void mailbox_free(struct mailbox *b);

/* Does typesel select type? (nx.h) */
bool mailbox_selects(int64_t typesel, int64_t type);

/* Select an unexpected message for r, or post it. */
void mailbox_post(struct node *n, struct receive *r);
/* Withdraw a receive that is not complete; a message already selected goes back to the unexpected. */
void mailbox_withdraw(struct node *n, struct receive *r);
bool mailbox_complete(struct node *n, const struct receive *r);
/* Put a complete message into the program's buffer: spends the copying, sets n->info, frees the message. call
 * names the call in the error for a message that is too long. */
void mailbox_take(struct node *n, struct receive *r, const char *call);
/* The first complete unexpected message that typesel selects, NULL if none. */
const struct message *mailbox_probe(struct node *n, int64_t typesel);

/* Message ids. 0 or more; -1 when all are taken. */
/* Follow a message for s until its buffer is free. */
void mailbox_follow(struct message *m, struct send *s);
long mailbox_id_new(struct node *n, bool sends);
struct receive *mailbox_id_receive(struct node *n, long id); /* NULL: no such id, or a send's */
struct send *mailbox_id_send(struct node *n, long id);
void mailbox_id_release(struct node *n, long id);

/* Handlers. */
void mailbox_post_handler(struct node *n, int64_t typesel, void *buf, size_t room, node_handler *handler);
struct send *mailbox_send_handler(struct node *n, node_handler *handler);
bool mailbox_armed(const struct node *n);     /* may a handler have to be run before the next call? */
vtime mailbox_next_due(const struct node *n); /* VT_NEVER: none due yet */
bool mailbox_handler_due(const struct node *n, vtime now);
void mailbox_run_handler(struct node *n); /* the first that is due */
#endif
