/* front.c - see front.h: the fast engine's. */
#include "os/front.h"
#include <assert.h>
#include "node/system.h"
#include "os/charge.h"
#include "os/deferred.h"
#include "os/gate.h"
#include "os/match.h"
#include "lp/clock.h"

void node_spend_on(struct node *n, enum node_task task, vtime t)
{
    t = node_system_time(n, t);
    if (n->deferred.open) {
        assert(task == NODE_CALL);
        deferred_spend(n, t);
        return;
    }
    clock_sync(&n->lp);
    clock_advance(&n->lp, t);
    node_account(n, task, t);
}

void front_post(struct node *n, struct receive *r)
{
    if (n->deferred.open)
        deferred_post(n, r);
    else
        match_post(n, r, node_now(n));
}

void front_send(struct node *n, struct message *first)
{
    if (n->deferred.open)
        deferred_send(n, first);
    else
        clock_advance_to(&n->lp, match_send(n, first, node_now(n)));
}

void front_received(struct node *n, struct message *m)
{
    if (n->deferred.open) {
        deferred_received(n, m);
        return;
    }
    node_spend_on(n, NODE_COPYING, match_copying(n, m));
    match_done_with(n, m, node_now(n));
}
