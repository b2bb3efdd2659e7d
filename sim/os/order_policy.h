/* order_policy.h - decides, in runs that must keep the orders of a schedule (replay/orders.h), what is left
 * to the moment otherwise: which receive gets which message, and when handlers run. */
#ifndef OS_ORDER_POLICY_H
#define OS_ORDER_POLICY_H
#include "node/system.h"

struct order_policy {
    /* matching.h's posted_take() and os/unexpected.h's unexpected_first(), for a node that keeps orders. Fail
     * if the message is for a receive that does not select it. */
    struct receive *(*take_posted)(struct node *n, const struct message *m);
    struct message *(*unexpected)(struct node *n, const struct receive *r);
    /* What a probe finds, complete or not; NULL: nothing. */
    struct message *(*probe)(const struct node *n, const struct selector *select);
    /* May the node's next handler run, as far as orders say? */
    bool (*lets_handler_run)(const struct node *n);
    /* Have all handlers run that run before the call that the node's program is about to begin? */
    bool (*lets_call_begin)(const struct node *n);
};

/* NULL: the node's machine keeps no orders. */
static inline const struct order_policy *order_policy_of(const struct node *n)
{
    const struct order_policy *p = n->sys->orders;
    return __builtin_expect(p != NULL, 0) ? p : NULL;
}
#endif
