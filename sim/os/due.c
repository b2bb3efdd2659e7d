/* due.c - see due.h. The handlers due are a ring; the mailbox has the last. */
#include "os/due.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lp/clock.h"
#include "lp/engine.h"
#include "net/protocol.h"
#include "node/system.h"
#include "os/observer.h"
#include "os/order_policy.h"

struct due due_take(struct mailbox *b)
{
    struct due *first = b->last_due->next, d = *first;
    b->last_due->next = first->next;
    if (b->last_due == first)
        b->last_due = NULL;
    free(first);
    return d;
}

void due_free(struct mailbox *b)
{
    while (b->last_due) {
        struct due d = due_take(b);
        if (d.receive && d.receive->m)
            protocol_message_free(d.receive->m);
        free(d.receive);
        free(d.send);
    }
}

/* By how much the node's next handler becomes due late, in a run with another timing than usual. */
static vtime lateness(const struct node *n)
{
    struct timing *t = n->sys->timing;
    return t ? timing_next_interrupt(t, node_timed(n)) : 0;
}

void due_add(struct node *n, vtime at, struct receive *r, struct send *s)
{
    lp_synchronise(&n->lp);
    vtime late = lateness(n);
    at += late;
    ANNOUNCE(n, handler_due, at, late);
    struct mailbox *b = &n->mailbox;
    struct due *d = xmalloc(sizeof *d);
    *d = (struct due){.at = at, .receive = r, .send = s, .next = d};
    if (b->last_due)
        d->next = b->last_due->next, b->last_due->next = d;
    b->last_due = d;
    lp_wake(&n->lp, at);
}

bool due_may_interrupt(const struct node *n)
{
    return n->mailbox.handlers > 0 && !n->handlers.masked && !n->in_handler;
}

vtime due_next(const struct node *n)
{
    const struct due *first = due_first(&n->mailbox);
    const struct order_policy *orders = order_policy_of(n);
    if (first && orders && !orders->lets_handler_run(n))
        return VT_NEVER; /* it waits for a call */
    return first ? vt_max(first->at, clock_when(&n->lp, n->handlers.share_until)) : VT_NEVER;
}

bool due_now(const struct node *n, vtime now)
{
    const struct due *first = due_first(&n->mailbox);
    const struct order_policy *orders = order_policy_of(n);
    return first && first->at <= now && !n->handlers.masked && !n->in_handler &&
           (!orders || orders->lets_handler_run(n));
}
