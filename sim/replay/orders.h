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
#ifndef REPLAY_ORDERS_H
#define REPLAY_ORDERS_H
#include "os/order_policy.h"

extern const struct order_policy orders_policy;
/* The lines that the run has not kept, the first of each node, of some nodes, as text, a line each; NULL:
 * none. Malloc'd. */
char *orders_unkept(const struct node_system *s);
#endif
