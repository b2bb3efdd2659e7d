/* due.h - the handlers of a node that are due: for a receive that is complete, or a send whose buffer is
 * free. Handlers run in the order in which they became due (handlers.h). */
#ifndef OS_DUE_H
#define OS_DUE_H
#include "node/node.h"

struct receive;
struct send;

struct due {
    vtime at;
    struct receive *receive;
    struct send *send;
    struct due *next;
};

/* A handler is due from time `at` on, or later in a run with another timing than usual: r's, whose message is
 * complete then, or s's, whose buffer is free. */
void due_add(struct node *n, vtime at, struct receive *r, struct send *s);
/* Takes the first; there must be one. The caller frees its receive or send. */
struct due due_take(struct mailbox *b);
/* Drops all handlers that are due. */
void due_free(struct mailbox *b);
/* The first; NULL: none. */
static inline const struct due *due_first(const struct mailbox *b)
{
    return b->last_due ? b->last_due->next : NULL;
}
/* May a handler have to run before the program's next call? */
bool due_may_interrupt(const struct node *n);
/* When the next handler is to interrupt the program, if that computes until then; VT_NEVER: none is due. */
vtime due_next(const struct node *n);
/* Is a handler due at this time that a waiting program lets run? */
bool due_now(const struct node *n, vtime now);
#endif
