/* orders.h - runs that must keep the orders of a schedule (timing/plan.h), such as a recording of NX on MPI:
 * which receive gets which message, and between which calls of its program a handler runs.
 *
 *     a receive with an order    selects that message only
 *     a receive without          selects no message that another receive has an order for
 *     a probe                    finds the message that the node's next receive is to get, if it selects that
 *     a handler with an order    becomes due when its program has begun so many calls; and the program's next
 *                                call waits for it
 *
 * What cannot be kept ends the run with an error, or stands still, which is a deadlock; its report names the
 * line of the schedule. */
#ifndef OS_ORDERS_H
#define OS_ORDERS_H
#include "node/system.h"

/* Does the machine keep orders? */
bool orders_are_kept(const struct node_system *s);
/* matching.h's posted_take() and os/unexpected.h's unexpected_first(), for a node that keeps orders. Fail if
 * the message is for a receive that does not select it. */
struct receive *orders_take_posted(struct node *n, const struct message *m);
struct message *orders_unexpected(struct node *n, const struct receive *r);
/* What a probe finds, complete or not; NULL: nothing. */
struct message *orders_probe(const struct node *n, const struct selector *select);
/* May the node's next handler run, as far as orders say? */
bool orders_let_handler_run(const struct node *n);
/* Have all handlers run that run before the call that the node's program is about to begin? */
bool orders_let_call_begin(const struct node *n);
/* The lines that the run has not kept, the first of each node, of some nodes, as text, a line each; NULL:
 * none. Malloc'd. */
char *orders_unkept(const struct node_system *s);
#endif
