/* order.h - a node's moments in the total order, on the node's stack. node_order() is
 * nx_api/contract/backend.h's: it waits until the node's present time is committed, as node_enter does, but
 * runs no handlers: for library calls that show something to the outside (a write) in places that are not
 * safe for a handler. */
#ifndef OS_ORDER_H
#define OS_ORDER_H
#include "lp/clock.h"
#include "node/self.h"

/* The node's time now, its computing included. */
static inline vtime node_now(struct node *n)
{
    return clock_sync(&n->lp);
}
/* Is something else to be committed before the node's call or poll at `now`? The fast engine's. */
bool order_must_yield(struct node *n, vtime now);
#endif
