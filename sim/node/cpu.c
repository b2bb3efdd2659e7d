/* cpu.c - see cpu.h. */
#include "node/cpu.h"
#include <errno.h>
#include "kernel/fiber.h"
#include "node/clock.h"
#include "node/mailbox.h"
#include "node/system.h"

/* The most calls a program makes without the scheduler seeing it: for time limits and the keyboard only. */
enum { MOST_UNSEEN = 4096 };

/* --- the scheduler's side --- */

/* A wait of `waited` is over, during which the system was busy for `busy`. */
static void account_wait(struct node *n, vtime waited, vtime busy)
{
    vtime beside = busy > waited ? busy - waited : 0, idle = waited - (busy - beside);
    n->stats.system -= beside;
    n->stats.beside += beside;
    n->stats.idle += idle;
    if (idle)
        waits_add(&n->stats.waits, n->call, n->awaits, n->awaited, idle);
}

static void block(struct node *n, vtime now)
{
    n->state = NODE_BLOCKED;
    n->wait.since = now;
    n->wait.busy = n->stats.system;
}

/* Has the program, which waits, anything to do now? */
static bool may_go_on(struct node *n, vtime now)
{
    return mailbox_handler_due(n, now) || n->wait.ready(n, n->wait.arg);
}

static void resume(struct node *n, vtime now)
{
    clock_advance_to(n, now);
    n->state = NODE_COMPUTING;
    n->sys->current = n;
    n->sys->unseen = 0;
    errno = n->saved_errno;
    n->clock.runs = true;
    fiber_resume(n->fiber);
    clock_sync(n);
    n->clock.runs = false;
    n->saved_errno = errno;
    n->sys->current = NULL;
}

/* A computing node has come to a call or check at `now`. */
static void go_on(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    if (n->state == NODE_ENDED)
        return; /* killed meanwhile */
    if (n->clock.stolen) {
        vtime until = now + n->clock.stolen;
        n->clock.stolen = 0;
        evq_put_late(n->sys->q, until, n->place, go_on, n, NULL);
        return;
    }
    clock_advance_to(n, now);
    if (n->wait.ready && evq_late_is_first(n->sys->q, now, n->place) && !n->sys->stop &&
        now <= n->sys->max_time && !may_go_on(n, now))
        block(n, now);
    else
        resume(n, now);
}

static void wake(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    if (n->state != NODE_BLOCKED)
        return;
    clock_advance_to(n, now);
    account_wait(n, now - n->wait.since, n->stats.system - n->wait.busy);
    if (may_go_on(n, now))
        resume(n, now);
    else
        block(n, now);
}

void node_wake(struct node *n, vtime t)
{
    evq_put_late(n->sys->q, t, n->place, wake, n, NULL);
}

void node_start(struct node *n, vtime t)
{
    evq_put_late(n->sys->q, t, n->place, go_on, n, NULL);
}

static void account(struct node *n, enum node_task task, vtime t)
{
    n->stats.tasks[task] += t;
    n->stats.system += t;
}

/* What takes an ordinary node's system t takes this one's so long. */
static vtime system_time(const struct node *n, vtime t)
{
    return n->system_milli == 1000 ? t : t * n->system_milli / 1000;
}

/* The system has the processor for t, beside or instead of the program. */
static void steal(struct node *n, enum node_task task, vtime t)
{
    if (n->state == NODE_ENDED)
        return; /* nobody's time any more */
    if (n->state == NODE_COMPUTING)
        n->clock.stolen += t;
    account(n, task, t);
}

vtime node_work(void *ctx, uint32_t node, enum proto_task task, vtime at, vtime t)
{
    struct node_system *sys = ctx;
    struct node *n = node_at(sys, node);
    t = system_time(n, t);
    n->sys_free = vt_max(at, n->sys_free) + t;
    steal(n, task == PROTO_SEND ? NODE_SENDING : NODE_RECEIVING, t);
    return n->sys_free;
}

void node_move(void *ctx, uint32_t node, enum proto_task task, vtime t)
{
    struct node_system *sys = ctx;
    struct node *n = node_at(sys, node);
    steal(n, task == PROTO_SEND ? NODE_FEEDING : NODE_EMPTYING, system_time(n, t));
}

/* --- the program's side --- */

/* Has the machine been told to stop, or this node come to the end of time? Then the scheduler wants to know. */
static bool must_stop(struct node *n, vtime now)
{
    if (now > n->sys->max_time && !n->sys->stop)
        node_system_fail(n->sys, STOP_VIRTUAL_TIME, "virtual time limit of %.6f s reached by %s%s%s",
                         vt_seconds(n->sys->max_time), n->name, n->call ? " in " : " computing",
                         n->call ? n->call : "");
    return n->sys->stop || ++n->sys->unseen > MOST_UNSEEN;
}

/* Is something else to happen before the node's call at `now`? */
static bool must_yield(struct node *n, vtime now)
{
    return n->clock.stolen || !evq_late_is_first(n->sys->q, now, n->place) || must_stop(n, now);
}

void node_order(struct node *n)
{
    vtime now = clock_sync(n);
    while (must_yield(n, now)) {
        evq_put_late(n->sys->q, now, n->place, go_on, n, NULL);
        fiber_yield(n->fiber);
        now = clock_sync(n);
    }
}

void node_enter(struct node *n, const char *call)
{
    n->call = call;
    n->call_has_type = n->awaits = false;
    n->call_since = clock_sync(n);
    do
        node_order(n);
    while (node_run_handlers(n));
}

void node_spend_on(struct node *n, enum node_task task, vtime t)
{
    t = system_time(n, t);
    clock_advance_to(n, clock_sync(n) + t);
    account(n, task, t);
}

void node_spend(struct node *n, vtime t)
{
    node_spend_on(n, NODE_CALL, t);
}

static vtime deadline(struct node *n, vtime now)
{
    vtime slice =
        vt_min(now + n->sys->longest_slice, n->sys->max_time == VT_NEVER ? VT_NEVER : n->sys->max_time + 1);
    if (!mailbox_armed(n))
        return slice;
    vtime due = vt_min(mailbox_next_due(n), proto_horizon(n->sys->proto, n->place, evq_next(n->sys->q)));
    return vt_min(slice, due);
}

void node_leave(struct node *n)
{
    n->call = NULL;
    clock_allow(n, deadline(n, clock_sync(n)));
}

/* A check of the program has found its time used up. */
void node_nxc_preempt(void);
void node_nxc_preempt(void)
{
    struct node *n = node_self();
    n->stats.slices++;
    n->sys->unseen += MOST_UNSEEN / 16; /* a slice takes longer than a call */
    do
        node_order(n);
    while (node_run_handlers(n));
    clock_allow(n, deadline(n, clock_sync(n)));
}

bool node_run_handlers(struct node *n)
{
    bool any = false;
    while (mailbox_handler_due(n, node_now(n))) {
        const char *call = n->call;
        long type = n->call_type, awaited = n->awaited;
        bool has_type = n->call_has_type, awaits = n->awaits;
        vtime since = n->call_since;
        mailbox_run_handler(n);
        n->call = call, n->call_type = type, n->call_has_type = has_type, n->call_since = since;
        n->awaited = awaited, n->awaits = awaits;
        any = true;
    }
    return any;
}

/* Handlers that have become due while the node came here; others will wake it. */
static void catch_up(struct node *n)
{
    while (node_run_handlers(n))
        node_order(n);
}

/* Switches away until the program has something to do; on the scheduler's side, go_on and wake see to that. True if it
 * has been blocked: then all earlier events have happened. */
static bool switch_away(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    n->wait.ready = ready, n->wait.arg = arg;
    fiber_yield(n->fiber);
    n->wait.ready = NULL;
    return n->wait.since != VT_NEVER;
}

void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    vtime now = clock_sync(n);
    n->wait.since = VT_NEVER;
    if (must_yield(n, now)) {
        evq_put_late(n->sys->q, now, n->place, go_on, n, NULL);
        if (!switch_away(n, ready, arg))
            node_order(n);
    }
    for (catch_up(n); !ready(n, arg); catch_up(n)) {
        block(n, node_now(n));
        switch_away(n, ready, arg);
    }
}

void node_cut(struct node *n, vtime t)
{
    vtime at = node_now(n) + n->clock.stolen;
    if (n->state == NODE_BLOCKED)
        account_wait(n, t - n->wait.since, n->stats.system - n->wait.busy);
    else if (at > t)
        clock_cut(n, at - t);
    n->clock.stolen = 0;
}
