/* account.c - see account.h. */
#include "node/account.h"
#include "node/clock.h"
#include "node/engine.h"
#include "node/handlers.h"
#include "node/system.h"

static void add(struct node *n, enum node_task task, vtime t)
{
    n->stats.tasks[task] += t;
    n->stats.system += t;
}

void node_account(struct node *n, enum node_task task, vtime t)
{
    add(n, task, t);
    handlers_share_used(n, t);
}

void node_spend(struct node *n, vtime t)
{
    node_spend_on(n, NODE_CALL, t);
}

vtime node_system_time(const struct node *n, vtime t)
{
    return n->system_milli == 1000 ? t : t * n->system_milli / 1000;
}

/* --- the system's part, in interrupts --- */

/* The system has the processor for t, beside or instead of the program. */
static void steal(struct node *n, enum node_task task, vtime t)
{
    if (n->state == NODE_ENDED)
        return; /* nobody's time any more */
    engine_touch(n);
    if (n->state == NODE_COMPUTING)
        n->clock.stolen += t;
    add(n, task, t);
}

vtime node_work(void *ctx, uint32_t node, enum protocol_task task, vtime at, vtime t)
{
    struct node_system *sys = ctx;
    struct node *n = node_at(sys, node);
    t = node_system_time(n, t);
    n->sys_free = vt_max(at, n->sys_free) + t;
    steal(n, task == PROTOCOL_SEND ? NODE_SENDING : NODE_RECEIVING, t);
    return n->sys_free;
}

void node_move(void *ctx, uint32_t node, enum protocol_task task, vtime t)
{
    struct node_system *sys = ctx;
    struct node *n = node_at(sys, node);
    steal(n, task == PROTOCOL_SEND ? NODE_FEEDING : NODE_EMPTYING, node_system_time(n, t));
}

/* --- waiting --- */

void account_block(struct node *n, vtime now)
{
    n->state = NODE_BLOCKED;
    n->blocked.since = now;
    n->blocked.busy = n->stats.system;
    n->share_until = 0;
}

void account_cut(struct node *n, vtime t)
{
    vtime waited = t - n->blocked.since, busy = n->stats.system - n->blocked.busy;
    vtime beside = busy > waited ? busy - waited : 0, idle = waited - (busy - beside);
    if (beside)
        n->stats.system -= beside, n->stats.beside += beside;
    n->stats.idle += idle;
    if (idle)
        waits_add(&n->stats.waits, n->call, n->awaits, n->awaited, idle);
}

bool account_unblock(struct node *n, vtime now)
{
    n->clock.now = now; /* which ready() may ask for */
    if (!handlers_due(n, now) && !n->wait.ready(n, n->wait.arg)) {
        n->clock.now = n->blocked.since;
        return false;
    }
    account_cut(n, now);
    n->state = NODE_COMPUTING;
    return true;
}
