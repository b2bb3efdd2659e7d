/* due.h - the handlers of a node that are to run: for a receive that is complete, or a send whose buffer is
 * free. They run in the order in which they became due: handlers.h. */
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

/* One is due from time `at` on: for r, whose message is complete then, or for s, whose buffer is free. */
void due_add(struct node *n, vtime at, struct receive *r, struct send *s);
/* Takes the first; there is one. Its receive or send is the caller's to free. */
struct due due_take(struct mailbox *b);
/* Throws all away. */
void due_free(struct mailbox *b);
/* The first; NULL: none. */
static inline const struct due *due_first(const struct mailbox *b)
{
    return b->last_due ? b->last_due->next : NULL;
}
/* May one have to run before the program's next call? */
bool due_may_interrupt(const struct node *n);
/* When the next is to interrupt the program, if that computes until then; VT_NEVER: none is known to be due.
 */
vtime due_next(const struct node *n);
/* Is one due that a program which waits lets run at this time? */
bool due_now(const struct node *n, vtime now);
#endif
