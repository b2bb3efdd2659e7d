/* cpu.c - the program's side of turns.h; turns.c has the scheduler's. */
#include <assert.h>
#include "kernel/fiber.h"
#include "node/account.h"
#include "node/clock.h"
#include "node/handlers.h"
#include "node/mailbox.h"
#include "node/pending.h"
#include "node/system.h"
#include "node/trace.h"
#include "node/turns.h"
#include "nx_api/contract/program_image.h"

/* For time limits and the keyboard only: the most calls between looks at them, and how many a look at a computing program
 * stands for. */
enum { MOST_UNSEEN = 4096, LOOK_CALLS = 64 };

/* Worth a thread of its own are stretches of a few microseconds of ours: clocks of an i860. What took so long behind the same
 * call the last time will again; and what has taken half as long will take longer. */
#define LONG_STRETCH (UINT64_C(80000) * NXC_UNITS_PER_CLOCK)

/* --- calls --- */

/* Has the machine been told to stop, or this node come to the end of time? Then the scheduler wants to know. */
static bool must_stop(struct node *n, vtime now)
{
    return n->sys->stop || now > n->sys->max_time || ++n->sys->unseen > MOST_UNSEEN;
}

static vtime end_of_time(const struct node *n)
{
    return n->sys->max_time == VT_NEVER ? VT_NEVER : n->sys->max_time + 1;
}

/* The earliest time at which anything may reach the node. */
static vtime horizon(const struct node *n)
{
    const struct node_system *s = n->sys;
    vtime next = vt_min(evq_next(s->q), bounds_least(&s->checks));
    if (s->workers)
        next = vt_min(next, workers_bound(s->workers));
    return proto_horizon(s->proto, n->place, next);
}

bool node_is_alone(const struct node *n, vtime t)
{
    return horizon(n) > t;
}

/* Until when the program may compute without looking at what comes, if a handler may have to run. */
static vtime deadline(struct node *n)
{
    vtime end = end_of_time(n);
    n->ahead.alert = handlers_armed(n);
    if (!n->ahead.alert)
        return end;
    if (n->ahead.up_to)
        return n->ahead.up_to;
    return vt_min(end, vt_min(handlers_next_due(n), horizon(n)));
}

/* What the program may spend was reckoned before the system took time from it. */
static void allow_anew(struct node *n)
{
    if (!n->call)
        clock_allow(n, deadline(n));
}

/* Nothing of a program that has stopped at a check comes before. (One that has had time taken from it in its own call is put off at
 * the check.) */
static vtime quiet_until(const struct node *n)
{
    if (n->in_handler || n->clock.stolen)
        return 0;
    return vt_min(clock_quiet(n), vt_min(end_of_time(n), handlers_next_due(n)));
}

/* Is something else to happen before the node's call at `now`? */
static bool must_yield(struct node *n, vtime now)
{
    if (n->ahead.up_to)
        return n->call || now >= n->ahead.up_to;
    return n->loose || n->pending.count || n->clock.stolen || !turn_is_first(n, now) || must_stop(n, now);
}

void node_yield_turn(struct node *n, vtime now)
{
    if (n->loose)
        n->ahead.arrived = now; /* for node_catch */
    else if (!n->call && n->ahead.alert)
        turn_at_check(n, now, quiet_until(n));
    else
        turn_put(n, now);
}

/* The program's turn has come, maybe without an event. (Where it only makes up for checks, that was long ago.) */
static void have_turn(struct node *n, vtime now)
{
    struct node_system *s = n->sys;
    if (n->ahead.up_to || turn_is_passed(n, now))
        return;
    s->reached = turn_reached(s);
    s->present = (struct instant){now, n->place};
}

void node_order(struct node *n)
{
    vtime now = clock_sync(n);
    n->pending.open = false;
    bool yielded = false;
    while (must_yield(n, now)) {
        node_yield_turn(n, now);
        n->frame = (uintptr_t)__builtin_frame_address(0);
        fiber_yield(&n->fiber);
        now = clock_sync(n);
        yielded = true;
    }
    have_turn(n, now);
    if (yielded)
        allow_anew(n);
}

/* A set of one call, or few: by the place of its name in a page, the same in every run. */
static uint64_t set_of(const char *call)
{
    return UINT64_C(1) << ((uintptr_t)call % 4096 / 8 % 64);
}

/* A stretch is over, and a call begins. Stretches that could not be handed out do not count. */
static void note_stretch(struct node *n)
{
    struct node_ahead *a = &n->ahead;
    if (!a->alert && clock_stretch(n) >= LONG_STRETCH)
        a->long_after |= a->after;
    else if (!a->alert)
        a->long_after &= ~a->after;
    a->after = set_of(n->call);
}

/* Will the program probably compute for long behind its call? */
static bool is_long_next(const struct node *n)
{
    return n->sys->workers && (n->ahead.long_after & n->ahead.after);
}

static void begin_call(struct node *n, const char *call, bool early)
{
    n->call = call;
    n->call_has_type = n->awaits = false;
    n->call_since = clock_stop(n);
    n->hands_over = early;
    if (n->sys->workers)
        note_stretch(n);
}

static void take_turn(struct node *n)
{
    n->call_since = VT_NEVER; /* it has not come so far */
    node_order(n);
    n->call_since = node_now(n);
    while (handlers_run(n, false))
        node_order(n);
    node_memory_settle(n);
}

void node_enter(struct node *n, const char *call)
{
    begin_call(n, call, false);
    take_turn(n);
}

/* Can the call that the program is in wait for its turn alone, while the program goes on? A program worth a thread of its own
 * gets it when its call is made. (Where programs come and go, few messages are worth it.) */
static bool may_pend(const struct node *n)
{
    const struct node_system *s = n->sys;
    return !n->loose && !n->armed && !n->is_host && !s->stop && n->call_since <= s->max_time &&
           !n->clock.stolen && !s->cube && !s->flushes && pending_room(n) && !mailbox_ignores(n) &&
           !is_long_next(n) && !turn_is_passed(n, n->call_since);
}

void node_enter_early(struct node *n, const char *call)
{
    begin_call(n, call, true);
    if (may_pend(n) && (n->pending.count || !turn_is_first(n, n->call_since)))
        pending_begin(n);
    else
        take_turn(n);
}

void node_spend_on(struct node *n, enum node_task task, vtime t)
{
    t = node_system_time(n, t);
    if (n->pending.open) {
        assert(task == NODE_CALL);
        pending_spend(n, t);
        return;
    }
    clock_sync(n);
    clock_advance(n, t);
    node_account(n, task, t);
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
    turn_put(n, pending_last(n));
    fiber_yield(&n->fiber);
}

/* Has the program handed out. What comes next may be on another thread. */
static void break_loose(struct node *n)
{
    n->loose = n->ahead.paused = true;
    n->ahead.work.place = n->place;
    atomic_store_explicit(&n->ahead.work.reached, clock_sync(n), memory_order_relaxed);
    fiber_yield(&n->fiber);
}

void node_leave(struct node *n)
{
    n->call = NULL;
    clock_sync(n);
    if (!n->pending.open) {
        node_memory_settle(n);
        clock_given_in_turn(n, n->clock.units);
    }
    n->pending.open = false;
    clock_give(n);
    clock_allow(n, deadline(n));
    if (n->pending.count == 0 && is_free(n, is_long_next(n)))
        break_loose(n);
}

/* A computing program lets others do something. */
static void look_around(struct node *n, vtime now)
{
    struct node_system *s = n->sys;
    if (n->loose) {
        n->ahead.paused = workers_pass(s->workers, &n->ahead.work, now);
        if (n->ahead.paused)
            fiber_yield(&n->fiber);
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
    uint64_t promised = clock_promised(n);
    if (!n->loose)
        n->sys->unseen += LOOK_CALLS / 8;
    do
        node_order(n);
    while (handlers_run(n, false) && (any = true));
    if (!any)
        return;
    node_memory_settle(n);
    clock_give(n);
    clock_given_in_turn(n, n->clock.units);
    clock_promise(n, promised);
}

/* A check of the program has found its time used up. */
void node_nxc_preempt(void);
void node_nxc_preempt(void)
{
    struct node *n = node_self();
    vtime now = clock_sync(n);
    clock_look_ahead(n);
    clock_look(n, trace_caller(__builtin_frame_address(0)));
    n->frame = (uintptr_t)__builtin_frame_address(0);
    n->at_poll = true;
    if (n->ahead.alert && !(n->loose && now < n->ahead.up_to))
        listen(n);
    else if (now > n->sys->max_time)
        node_order(n);
    else
        look_around(n, now);
    clock_allow(n, n->loose && !n->ahead.alert ? end_of_time(n) : deadline(n));
    n->at_poll = false;
}

/* Handlers that have become due while the node came here; others will wake it. Is what it waits for there? */
static bool catch_up(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    bool is_ready = ready(n, arg);
    while (handlers_run(n, !is_ready)) {
        node_order(n);
        is_ready = ready(n, arg);
    }
    return is_ready;
}

/* Switches away until the program has something to do; on the scheduler's side, go_on and wake see to that. True if it
 * has been blocked: then all earlier events have happened. */
static bool switch_away(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    n->wait.ready = ready, n->wait.arg = arg;
    n->frame = (uintptr_t)__builtin_frame_address(0);
    fiber_yield(&n->fiber);
    n->wait.ready = NULL;
    return n->blocked.since != VT_NEVER;
}

void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    vtime now = clock_sync(n);
    n->pending.open = false;
    bool yields = must_yield(n, now), early = n->hands_over;
    if (yields && early && ready(n, arg) && may_pend(n) && now <= n->sys->max_time && !mailbox_may_grant(n) &&
        node_is_alone(n, now)) {
        pending_go_on(n);
        return;
    }
    n->hands_over = false;
    n->blocked.since = VT_NEVER;
    if (yields) {
        n->rests = early && turn_may_rest(n, now) && !ready(n, arg);
        if (!n->rests)
            node_yield_turn(n, now);
        if (!switch_away(n, ready, arg))
            node_order(n);
    } else {
        have_turn(n, now);
    }
    while (!catch_up(n, ready, arg)) {
        account_block(n, node_now(n));
        switch_away(n, ready, arg);
    }
}
