/* cpu.c - see cpu.h. */
#include "node/cpu.h"
#include <assert.h>
#include <errno.h>
#include <stddef.h>
#include "kernel/fiber.h"
#include "node/clock.h"
#include "node/mailbox.h"
#include "node/pending.h"
#include "node/system.h"
#include "nx_api/nxcc/image.h"

/* For time limits and the keyboard only: the most calls between looks at them, and how many a look at a computing program
 * stands for. */
enum { MOST_UNSEEN = 4096, LOOK_CALLS = 64 };

/* Worth a thread of its own are stretches of a few microseconds of ours: clocks of an i860. What took so long the last
 * time will again; and what has taken half as long will take longer. */
#define LONG_STRETCH (UINT64_C(80000) * NXC_UNITS_PER_CLOCK)

/* --- errno --- */

__attribute__((noipa)) int node_errno(void)
{
    return errno;
}

__attribute__((noipa)) void node_set_errno(int error)
{
    errno = error;
}

/* --- the scheduler's side --- */

static void go_on(void *ctx, void *arg, vtime now);
static void wake(void *ctx, void *arg, vtime now);

static void put_go_on(struct node *n, vtime t)
{
    evq_put_late(n->sys->q, t, n->place, go_on, n, NULL);
}

/* A computing node's program has stopped at a check and is not gone on with before t: until then it makes no call. */
static void stop_at_check(struct node *n, vtime check, vtime t)
{
    n->ahead.stopped = true;
    n->ahead.check = check;
    bounds_set(&n->sys->checks, n->place, vt_max(check, t));
}

static void leave_check(struct node *n)
{
    n->ahead.stopped = false;
    bounds_set(&n->sys->checks, n->place, VT_NEVER);
}

/* The node whose turn comes so many events after the next; NULL: unknown, or something else happens then. */
static struct node *coming(const struct node_system *s, unsigned after)
{
    evq_fire *fire;
    struct node *n = evq_coming(s->q, after, &fire);
    return fire == go_on || fire == wake ? n : NULL;
}

/* With thousands of nodes, none of what a node needs is in the caches when its turn comes. Loading begins some events ahead:
 * the node first, then what it points to. */
static void warm_coming(const struct node_system *s)
{
    enum { LINE = 64, STACK = 12 * LINE }; /* from a program's call to the switch: some functions */
    enum { FAR = 5, NEAR = 2 };
    const struct node *n = coming(s, FAR);
    for (size_t i = 0; n && i < offsetof(struct node, name); i += LINE)
        __builtin_prefetch((const char *)n + i, 1);
    n = coming(s, NEAR);
    if (!n || n->state == NODE_ENDED || n->ahead.loose)
        return;
    __builtin_prefetch(n->mailbox, 1);
    __builtin_prefetch(n->fiber, 1);
    __builtin_prefetch(n->image);
    __builtin_prefetch(n->warm.left, 1);
    for (size_t i = 0; n->warm.stack && i < STACK; i += LINE)
        __builtin_prefetch(n->warm.stack + i, 1);
}

/* Lets the program run on this thread until it yields. */
static void run(struct node *n)
{
    errno = n->saved_errno;
    n->clock.runs = true;
    if (n->sys->run)
        n->sys->run(n);
    else
        fiber_resume(n->fiber);
    n->warm.stack = fiber_innermost(n->fiber);
    clock_sync(n);
    n->clock.runs = false;
    n->saved_errno = errno;
}

static void show_crash(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    n->sys->stop_at = now;
    if (n->state != NODE_ENDED)
        n->sys->crashed(n);
}

/* A program has crashed somewhere before its next look, however far it was let run. In a call that is now. */
static void crash(struct node *n)
{
    if (n->call)
        show_crash(n, NULL, node_now(n));
    else
        evq_put_late(n->sys->q, clock_next_look(n), n->place, show_crash, n, NULL);
}

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

/* Has the machine been told to stop, or this node come to the end of time? */
static bool past_end(struct node *n, vtime now)
{
    if (now > n->sys->max_time && !n->sys->stop) {
        pending_take_back(n);
        node_system_fail(n->sys, STOP_VIRTUAL_TIME, "virtual time limit of %.6f s reached by %s%s%s",
                         vt_seconds(n->sys->max_time), n->name, n->call ? " in " : " computing",
                         n->call ? n->call : "");
    }
    return n->sys->stop;
}

/* Has the program, which waits, anything to do now? */
static bool may_go_on(struct node *n, vtime now)
{
    return mailbox_handler_due(n, now) || n->wait.ready(n, n->wait.arg);
}

static void run_warm(struct node *n)
{
    n->state = NODE_COMPUTING;
    n->sys->unseen = 0;
    run(n);
    if (n->crash && n->pending.count == 0)
        crash(n);
    else if (n->ahead.loose)
        workers_hand(n->sys->workers, &n->ahead.work);
}

static void run_on(struct node *n)
{
    warm_coming(n->sys);
    run_warm(n);
}

static void resume(struct node *n, vtime now)
{
    clock_advance_to(n, now);
    run_on(n);
}

bool node_run_ahead(struct node *n)
{
    n->ahead.paused = false;
    run(n);
    return n->crash || !n->ahead.paused;
}

void node_catch(struct node *n)
{
    n->ahead.loose = false;
    if (n->crash)
        crash(n);
    else
        put_go_on(n, n->ahead.arrived);
}

/* Is a node's check to come before time and place? */
static bool check_is_before(const struct node_system *s, vtime time, uint32_t place)
{
    vtime check = bounds_least(&s->checks);
    return check < time || (check == time && check != VT_NEVER && bounds_place(&s->checks) < place);
}

/* Is the node's call or check at `now` the machine's earliest event? */
static bool is_first(struct node *n, vtime now)
{
    const struct node_system *s = n->sys;
    return evq_late_is_first(s->q, now, n->place) && !check_is_before(s, now, n->place) &&
           (!s->workers || workers_allow(s->workers, now, n->place));
}

/* A computing node has come to a call or check. */
static void arrive(struct node *n, vtime now)
{
    clock_advance_to(n, now);
    if (n->wait.ready && is_first(n, now) && !n->sys->stop && now <= n->sys->max_time && !may_go_on(n, now))
        block(n, now);
    else
        resume(n, now);
}

/* What the program has been waiting for with nothing pending any more, or what has become of it. */
static void pending_made(struct node *n)
{
    bool drains = n->pending.drains;
    n->pending.drains = false;
    if (n->crash)
        crash(n);
    else if (drains)
        run_on(n);
    else
        put_go_on(n, clock_sync(n));
}

/* Pending calls have their turn: the first, and those for which it is then the turn already. */
static void make_pending(struct node *n, vtime now)
{
    do {
        if (past_end(n, now))
            return;
        pending_commit(n, now);
        if (n->pending.count == 0) {
            pending_made(n);
            return;
        }
        now = pending_next(n);
    } while (is_first(n, now));
    put_go_on(n, now);
}

/* It is the turn of a node that computes ahead: of its call or check, or of the first of its pending calls. */
static void go_on(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    if (n->state == NODE_ENDED)
        return; /* killed meanwhile */
    if (n->clock.stolen) {
        vtime until = now + n->clock.stolen;
        n->clock.stolen = 0;
        put_go_on(n, until);
    } else if (n->pending.count) {
        make_pending(n, now);
    } else {
        arrive(n, now);
    }
}

/* The turn of a node's check. */
static void check(struct node *n)
{
    leave_check(n);
    if (n->clock.stolen) {
        go_on(n, NULL, n->ahead.check);
        return;
    }
    clock_advance_to(n, n->ahead.check);
    run_warm(n);
}

void node_catch_up(struct node *n, vtime t)
{
    if (!n->ahead.stopped)
        return;
    if (n->ahead.check < t && !n->clock.stolen) {
        n->ahead.up_to = t;
        check(n);
        n->ahead.up_to = 0;
    }
    if (n->ahead.stopped)
        stop_at_check(n, n->ahead.check, 0);
}

void node_catch_up_now(struct node *n)
{
    const struct node_system *s = n->sys;
    node_catch_up(n, s->present.time + (n->place < s->present.place));
}

vtime node_next(const struct node_system *s, uint32_t *place)
{
    vtime time = evq_next(s->q);
    *place = evq_next_place(s->q);
    if (!check_is_before(s, time, *place))
        return time;
    *place = bounds_place(&s->checks);
    return bounds_least(&s->checks);
}

bool node_step(struct node_system *s)
{
    vtime time = evq_next(s->q);
    uint32_t place = evq_next_place(s->q);
    if (check_is_before(s, time, place)) {
        check(node_at(s, bounds_place(&s->checks)));
        return true;
    }
    s->present.time = time, s->present.place = place;
    return evq_step(s->q);
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
    put_go_on(n, t);
}

void node_account(struct node *n, enum node_task task, vtime t)
{
    n->stats.tasks[task] += t;
    n->stats.system += t;
}

/* What takes an ordinary node's system t takes this one's so long. */
vtime node_system_time(const struct node *n, vtime t)
{
    return n->system_milli == 1000 ? t : t * n->system_milli / 1000;
}

/* The system has the processor for t, beside or instead of the program. */
static void steal(struct node *n, enum node_task task, vtime t)
{
    if (n->state == NODE_ENDED)
        return; /* nobody's time any more */
    node_catch_up_now(n);
    if (n->state == NODE_COMPUTING)
        n->clock.stolen += t;
    node_account(n, task, t);
}

vtime node_work(void *ctx, uint32_t node, enum proto_task task, vtime at, vtime t)
{
    struct node_system *sys = ctx;
    struct node *n = node_at(sys, node);
    t = node_system_time(n, t);
    n->sys_free = vt_max(at, n->sys_free) + t;
    steal(n, task == PROTO_SEND ? NODE_SENDING : NODE_RECEIVING, t);
    return n->sys_free;
}

void node_move(void *ctx, uint32_t node, enum proto_task task, vtime t)
{
    struct node_system *sys = ctx;
    struct node *n = node_at(sys, node);
    steal(n, task == PROTO_SEND ? NODE_FEEDING : NODE_EMPTYING, node_system_time(n, t));
}

/* --- the program's side --- */

/* Has the machine been told to stop, or this node come to the end of time? Then the scheduler wants to know. */
static bool must_stop(struct node *n, vtime now)
{
    return past_end(n, now) || ++n->sys->unseen > MOST_UNSEEN;
}

static vtime end_of_time(const struct node *n)
{
    return n->sys->max_time == VT_NEVER ? VT_NEVER : n->sys->max_time + 1;
}

/* Until when the program may compute without looking at what comes: if a handler may have to run, the earliest time at
 * which anything may reach the node. */
static vtime deadline(struct node *n)
{
    const struct node_system *s = n->sys;
    vtime end = end_of_time(n);
    n->ahead.alert = mailbox_armed(n);
    if (!n->ahead.alert)
        return end;
    if (n->ahead.up_to)
        return n->ahead.up_to;
    vtime next = vt_min(evq_next(s->q), bounds_least(&s->checks));
    if (s->workers)
        next = vt_min(next, workers_bound(s->workers));
    return vt_min(end, vt_min(mailbox_next_due(n), proto_horizon(s->proto, n->place, next)));
}

/* What the program may spend was reckoned before the system took time from it. */
static void allow_anew(struct node *n)
{
    if (!n->call)
        clock_allow(n, deadline(n));
}

/* Nothing of a program that has stopped at a check comes before. */
static vtime quiet_until(const struct node *n)
{
    if (n->in_handler)
        return 0;
    return vt_min(clock_quiet(n), vt_min(end_of_time(n), mailbox_next_due(n)));
}

/* Is something else to happen before the node's call at `now`? */
static bool must_yield(struct node *n, vtime now)
{
    if (n->ahead.up_to)
        return n->call || now >= n->ahead.up_to;
    return n->ahead.loose || n->pending.count || n->clock.stolen || !is_first(n, now) || must_stop(n, now);
}

/* Yields to what is to happen before the node's call at `now`. */
static void yield_turn(struct node *n, vtime now)
{
    if (n->ahead.loose)
        n->ahead.arrived = now; /* for node_catch */
    else if (!n->call && n->ahead.alert)
        stop_at_check(n, now, quiet_until(n));
    else if (n->pending.count == 0)
        put_go_on(n, now);
}

void node_order(struct node *n)
{
    vtime now = clock_sync(n);
    pending_end(n);
    bool yielded = false;
    while (must_yield(n, now)) {
        yield_turn(n, now);
        fiber_yield(n->fiber);
        now = clock_sync(n);
        yielded = true;
    }
    clock_is_known(n);
    if (yielded)
        allow_anew(n);
}

static void begin_call(struct node *n, const char *call, bool early)
{
    n->call = call;
    n->call_has_type = n->awaits = false;
    n->call_since = clock_sync(n);
    n->pending.early = early;
    if (n->image)
        n->ahead.computed = clock_stretch(n);
}

static void take_turn(struct node *n)
{
    do
        node_order(n);
    while (node_run_handlers(n));
    node_memory_settle(n);
}

void node_enter(struct node *n, const char *call)
{
    begin_call(n, call, false);
    take_turn(n);
}

/* Can the call that begins wait for its turn alone, while the program goes on? A program worth a thread of its own gets
 * it when its call is made. */
static bool may_pend(const struct node *n)
{
    const struct node_system *s = n->sys;
    return !n->ahead.loose && !n->stats.armed && !n->is_host && !s->stop && n->call_since <= s->max_time &&
           pending_room(n) && !mailbox_ignores(n) && !(s->workers && n->ahead.computed >= LONG_STRETCH);
}

void node_enter_early(struct node *n, const char *call)
{
    begin_call(n, call, true);
    bool waits = !n->ahead.loose && (n->pending.count || n->clock.stolen || !is_first(n, n->call_since));
    if (!waits || !may_pend(n)) {
        take_turn(n);
        return;
    }
    if (n->pending.count == 0)
        put_go_on(n, n->call_since);
    pending_begin(n);
}

void node_spend_on(struct node *n, enum node_task task, vtime t)
{
    t = node_system_time(n, t);
    if (n->pending.open) {
        assert(task == NODE_CALL);
        pending_spend(n, t);
        return;
    }
    clock_advance_to(n, clock_sync(n) + t);
    node_account(n, task, t);
}

void node_spend(struct node *n, vtime t)
{
    node_spend_on(n, NODE_CALL, t);
}

/* --- computing ahead --- */

/* Is the program one that any thread may run until its next call? */
static bool is_free(const struct node *n, bool is_long)
{
    return n->sys->workers && !n->ahead.alert && !n->in_handler && workers_worth(n->sys->workers, is_long);
}

/* Waits until nothing is pending: the committing thread sees to that. */
static void drain(struct node *n)
{
    if (n->pending.count == 0)
        return;
    n->pending.drains = true;
    fiber_yield(n->fiber);
}

/* Has the program handed out. What comes next may be on another thread. */
static void break_loose(struct node *n)
{
    n->ahead.loose = n->ahead.paused = true;
    n->ahead.work.place = n->place;
    atomic_store_explicit(&n->ahead.work.reached, clock_sync(n), memory_order_relaxed);
    fiber_yield(n->fiber);
}

void node_leave(struct node *n)
{
    n->call = NULL;
    clock_sync(n);
    if (n->pending.open) {
        pending_end(n);
    } else {
        node_memory_settle(n);
        clock_is_known(n);
    }
    clock_give(n);
    clock_allow(n, deadline(n));
    if (n->pending.count == 0 && is_free(n, n->ahead.computed >= LONG_STRETCH))
        break_loose(n);
}

/* A computing program lets others do something. */
static void look_around(struct node *n, vtime now)
{
    struct node_system *s = n->sys;
    if (n->ahead.loose) {
        n->ahead.paused = workers_pass(s->workers, &n->ahead.work, now);
        if (n->ahead.paused)
            fiber_yield(n->fiber);
    } else if (is_free(n, clock_stretch(n) >= LONG_STRETCH / 2)) {
        drain(n);
        break_loose(n);
    } else if (s->look && (s->unseen += LOOK_CALLS) > MOST_UNSEEN) {
        s->unseen = 0;
        s->look(s->look_ctx);
        if (s->stop)
            node_order(n);
    }
}

/* Something may have come for an alert program. */
static void listen(struct node *n)
{
    bool any = false;
    n->sys->unseen += LOOK_CALLS / 8;
    do
        node_order(n);
    while (node_run_handlers(n) && (any = true));
    if (!any)
        return;
    node_memory_settle(n);
    clock_give(n);
}

/* A check of the program has found its time used up. */
void node_nxc_preempt(void);
void node_nxc_preempt(void)
{
    struct node *n = node_self();
    vtime now = clock_sync(n);
    n->stats.slices++;
    clock_look(n);
    if (n->ahead.alert)
        listen(n);
    else if (now > n->sys->max_time)
        node_order(n);
    else
        look_around(n, now);
    clock_allow(n, n->ahead.loose ? end_of_time(n) : deadline(n));
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
    n->frame = (uintptr_t)__builtin_frame_address(0);
    fiber_yield(n->fiber);
    n->wait.ready = NULL;
    return n->wait.since != VT_NEVER;
}

void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    vtime now = clock_sync(n);
    pending_end(n);
    n->pending.early = false;
    n->wait.since = VT_NEVER;
    if (must_yield(n, now)) {
        yield_turn(n, now);
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
    pending_take_back(n);
    node_catch_up(n, t);
    leave_check(n);
    vtime at = node_now(n) + n->clock.stolen;
    if (n->state == NODE_BLOCKED)
        account_wait(n, t - n->wait.since, n->stats.system - n->wait.busy);
    else if (at > t)
        clock_cut(n, at - t);
    n->cut_short = n->state == NODE_COMPUTING;
    n->clock.stolen = 0;
}
