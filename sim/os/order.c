/* order.c - see order.h: the fast engine's. */
#include "os/order.h"
#include "lp/dispatch.h"
#include "lp/lookahead.h"
#include "nx_api/contract/backend.h"

/* What the program may spend was reckoned before the system took time from it. */
static void allow_anew(struct node *n)
{
    if (!n->call.name)
        clock_allow(&n->lp, lp_deadline(&n->lp));
}

/* Is something else to be committed before the node's call at `now`? */
bool order_must_yield(struct node *n, vtime now)
{
    return n->deferred.count || lp_must_yield(&n->lp, now);
}

void node_order(struct node *n)
{
    vtime now = node_now(n);
    n->deferred.open = false;
    bool yielded = false;
    while (order_must_yield(n, now)) {
        lp_prepare_yield(&n->lp, now);
        n->wait.frame = (uintptr_t)__builtin_frame_address(0);
        lp_yield(&n->lp);
        now = node_now(n);
        yielded = true;
    }
    lp_commit(&n->lp, now);
    if (yielded)
        allow_anew(n);
}
