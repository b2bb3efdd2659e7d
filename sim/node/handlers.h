/* handlers.h - the handlers of a node: those of hrecv, hsend and their kin. They run in the order in which they became due. */
#ifndef NODE_HANDLERS_H
#define NODE_HANDLERS_H
#include "node/node.h"

struct receive;
struct send;

/* One is due from time `at` on: for r, whose message is complete then, or for s, whose buffer is free. */
void handlers_add(struct node *n, vtime at, struct receive *r, struct send *s);
/* Throws away those that are due. */
void handlers_free(struct mailbox *b);
/* May one have to be run before the program's next call? */
bool handlers_armed(const struct node *n);
/* When the next is due, or was; VT_NEVER: none is known to be. */
vtime handlers_next_due(const struct node *n);
/* Is one to be run at this time? */
bool handlers_due(const struct node *n, vtime now);
/* On the node's stack, in its turn: runs the first that is due. False: none is. When one has run, the program's time is later,
 * and what happens before is to happen before the next (node_order). */
bool handlers_run(struct node *n);
/* They are no longer held back, by the program or by another that ran. */
void handlers_open(struct node *n);
#endif
