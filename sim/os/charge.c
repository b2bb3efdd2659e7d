/* charge.c - see charge.h. */
#include "os/charge.h"
#include "lp/clock.h"
#include "lp/engine.h"
#include "node/system.h"
#include "os/observer.h"
#include "os/share.h"

static void add(struct node *n, enum node_task task, vtime t)
{
    n->times.tasks[task] += t;
    n->times.system += t;
}

void node_account(struct node *n, enum node_task task, vtime t)
{
    add(n, task, t);
    ANNOUNCE(n, charged, t, 0, false);
    share_use(n, t);
}

void charge_undo(struct node *n, enum node_task task, vtime t)
{
    n->times.tasks[task] -= t;
    n->times.system -= t;
    ANNOUNCE(n, charged, -t, 0, false);
}

vtime node_system_time(const struct node *n, vtime t)
{
    const uint64_t milli = n->system_milli;
    return milli == 1000 ? t : t / 1000 * milli + t % 1000 * milli / 1000; /* t * milli may overflow */
}

/* --- the system's part, in interrupts --- */

/* The system has the processor for t: instead of a computing program, or while the program waits. */
static void steal(struct node *n, enum node_task task, vtime at, vtime t)
{
    if (n->lp.state == LP_ENDED)
        return; /* the node has no program whose time it would be */
    lp_synchronise(&n->lp);
    bool computes = lp_computes(&n->lp);
    if (computes) {
        clock_steal(&n->lp, t);
        if (at <= n->in_kernel)
            n->in_kernel += t;
    }
    add(n, task, t);
    ANNOUNCE(n, charged, t, 0, computes);
}

vtime node_work(void *ctx, uint32_t node, enum protocol_task task, vtime at, vtime t)
{
    struct node *n = node_at(ctx, node);
    t = node_system_time(n, t);
    n->times.sys_free = vt_max(at, n->times.sys_free) + t;
    enum node_task what = task == PROTOCOL_SEND ? NODE_SENDING : NODE_RECEIVING;
    steal(n, what, at, t);
    ANNOUNCE(n, system, what, n->times.sys_free, t);
    return n->times.sys_free;
}

vtime charge_entry(struct node_system *sys, uint32_t node, vtime at)
{
    struct node *n = node_at(sys, node);
    lp_synchronise(&n->lp);
    bool enters = lp_computes(&n->lp) && at > n->in_kernel && at > n->times.sys_free;
    return enters ? sys->cfg->entry_ps : 0;
}

void node_move(void *ctx, uint32_t node, enum protocol_task task, vtime at, vtime t)
{
    struct node *n = node_at(ctx, node);
    enum node_task what = task == PROTOCOL_SEND ? NODE_FEEDING : NODE_EMPTYING;
    t = node_system_time(n, t);
    steal(n, what, at, t);
    ANNOUNCE(n, system, what, at + t, t);
}

/* --- waiting --- */

void charge_wait_begins(struct node *n)
{
    n->wait.system = n->times.system;
}

void charge_wait_ends(struct node *n, vtime t)
{
    vtime waited = t - n->lp.blocked_since, busy = n->times.system - n->wait.system;
    vtime overlapped = busy > waited ? busy - waited : 0, idle = waited - (busy - overlapped);
    if (overlapped)
        n->times.system -= overlapped, n->stats.overlapped += overlapped;
    n->stats.idle += idle;
    ANNOUNCE(n, waited, n->lp.blocked_since, t, waited - idle);
    ANNOUNCE(n, charged, -overlapped, idle, false);
    if (idle)
        waits_add(&n->stats.waits, n->call.name, n->call.awaits, n->call.awaited, idle);
}

/* --- sums --- */

vtime charge_sum(const struct node *n)
{
    return clock_of_units(&n->lp, n->lp.clock.units) + n->stats.idle + n->times.system;
}

bool charge_adds_up(const struct node *n)
{
    const struct node_stats *s = &n->stats;
    vtime tasks = 0, waits = 0;
    for (int i = 0; i < NODE_TASKS; i++)
        tasks += n->times.tasks[i];
    for (size_t i = 0; i < s->waits.count; i++)
        waits += s->waits.list[i].idle;
    return charge_sum(n) == s->ended_at - s->away + n->lp.clock.stolen &&
           tasks == n->times.system + s->overlapped && waits == s->idle;
}
