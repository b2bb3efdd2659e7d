/* handlers.c - the handlers of a node: those of hrecv, hsend and their variants. A handler that is due runs
 * on its program's stack, where the program can be interrupted: at a poll, or in a call; never inside of
 * another handler. See handlers.h. */
#include "os/handlers.h"
#include <stdlib.h>
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "lp/clock.h"
#include "lp/engine.h"
#include "node/system.h"
#include "os/due.h"
#include "os/fail.h"
#include "os/front.h"
#include "os/gate.h"
#include "os/order.h"
#include "os/observer.h"
#include "os/share.h"

void mailbox_post_handler(struct node *n, const struct receive *what)
{
    struct receive *r = xmalloc(sizeof *r);
    *r = *what;
    n->mailbox.handlers++;
    n->handlers.armed = n->deferred.never = true;
    mailbox_post(n, r);
}

struct send *mailbox_send_handler(struct node *n, mailbox_handler *handler, long param)
{
    struct send *s = xcalloc(1, sizeof *s);
    s->handler = handler, s->param = param;
    n->mailbox.handlers++;
    n->handlers.armed = n->deferred.never = true;
    return s;
}

/* Handlers are let run from now on. */
void handlers_open(struct node *n)
{
    n->handlers.opened_at = node_now(n);
    n->handlers.opened_units = n->lp.clock.units;
}

/* The delay of a handler that was due at a time: none if its program has computed nothing since handlers were
 * let run; otherwise counted from then on at most. */
static vtime delay(struct node *n, vtime due)
{
    vtime now = node_now(n), from = vt_max(due, n->handlers.opened_at);
    return n->lp.clock.units == n->handlers.opened_units || from > now ? 0 : now - from;
}

/* Runs the first handler that is due. */
static void run_first(struct node *n)
{
    struct mailbox *b = &n->mailbox;
    struct due d = due_take(b);
    struct node_info before = n->info;
    b->handlers--;
    n->stats.handlers++;
    n->stats.latest = vt_max(n->stats.latest, delay(n, d.at));
    n->in_handler = true;
    ANNOUNCE(n, handler_begins, &d);

    mailbox_handler *handler = d.receive ? d.receive->handler : d.send->handler;
    long param = d.receive ? d.receive->param : d.send->param;
    node_spend_on(n, NODE_INTERRUPT, n->sys->cfg->interrupt_ps / 2);
    if (!d.receive)
        n->info = d.send->info;
    else if (mailbox_take(n, d.receive) < 0)
        node_fail(n, "hrecv: %s", n->cold->error->text);
    free(d.receive);
    free(d.send);
    node_leave(n);
    crossing_call(handler, n->info.type, n->info.count, n->info.node, n->info.pid, param);
    node_enter(n, "(the end of a handler)");
    node_spend_on(n, NODE_INTERRUPT, n->sys->cfg->interrupt_ps - n->sys->cfg->interrupt_ps / 2);

    ANNOUNCE(n, handler_ends);
    n->in_handler = false;
    handlers_open(n);
    n->info = before;
}

/* The same, inside a call: afterwards reports tell of that call again, not of those that the handler has
 * made. */
static void run_within(struct node *n)
{
    struct node_call call = n->call;
    run_first(n);
    n->call = call;
}

bool handlers_mask(struct node *n, bool masked)
{
    bool before = n->handlers.masked;
    n->handlers.masked = masked;
    ANNOUNCE(n, masks, masked);
    return before;
}

/* The same, instead of the program, which would have gone on meanwhile: it has its share before the next
 * handler. */
static void interrupt(struct node *n)
{
    vtime begun = node_now(n);
    run_within(n);
    vtime ended = node_now(n), stood = ended - begun;
    n->stats.stood += stood;
    ANNOUNCE(n, interrupted, begun, ended);
    share_give(n, stood);
}

bool handlers_run_due(struct node *n, bool waits)
{
    if (!due_now(n, node_now(n)))
        return false;
    if (waits)
        run_within(n);
    else if (n->handlers.share_until <= n->lp.clock.units)
        interrupt(n);
    else
        return false;
    return true;
}

bool handlers_run_held(struct node *n, vtime t)
{
    if (!due_now(n, t))
        return false;
    interrupt(n);
    return true;
}
