/* turns.c - see turns.h. */
#include "node/turns.h"
#include <errno.h>
#include <stddef.h>
#include "kernel/fiber.h"
#include "node/clock.h"
#include "node/cpu.h"
#include "node/mailbox.h"
#include "node/pending.h"
#include "node/system.h"

static void go_on(void *ctx, void *arg, vtime now);
static void wake(void *ctx, void *arg, vtime now);

void turn_put(struct node *n, vtime t)
{
    evq_put_late(n->sys->q, t, n->place, go_on, n, NULL);
}

void turn_at_check(struct node *n, vtime check, vtime t)
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
 * the node first, then what it points to. (Inlined: GCC takes a function that only loads ahead for one without effect, and drops
 * its calls.) */
static inline __attribute__((always_inline)) void warm_coming(const struct node_system *s)
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
    n->sys->stop_at = (struct instant){now, n->place};
    if (n->state != NODE_ENDED)
        n->sys->crashed(n);
}

static void show_crash_in_call(void *ctx, void *arg, vtime now)
{
    (void)now;
    show_crash(ctx, arg, node_now(ctx));
}

/* A program has crashed somewhere before its next look, however far it was let run. In a call that is in its turn. */
static void crash(struct node *n)
{
    if (n->pending.open)
        evq_put_late(n->sys->q, pending_crashes(n), n->place, show_crash_in_call, n, NULL);
    else if (n->call)
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

void turn_block(struct node *n, vtime now)
{
    n->state = NODE_BLOCKED;
    n->wait.since = now;
    n->wait.busy = n->stats.system;
}

bool turn_may_rest(const struct node *n, vtime now)
{
    return !n->stats.armed && !n->is_host && !n->ahead.loose && !n->clock.stolen && !n->sys->stop &&
           now <= n->sys->max_time;
}

bool turn_rest_ends(struct node *n, struct instant at)
{
    if (!n->wait.rests)
        return false;
    n->wait.rests = false;
    if (pending_make_until(n, at)) {
        pending_tell(n);
        return true;
    }
    vtime turn = clock_sync(n);
    if (!instant_before(turn, n->place, at))
        return true;
    turn_block(n, turn);
    return false;
}

void turn_put_again(struct node *n)
{
    n->clock.counted = n->clock.stolen;
    turn_put(n, (n->pending.count ? pending_next(n) : clock_sync(n)) + n->clock.counted);
}

/* Has the program, which waits, anything to do now? */
static bool may_go_on(struct node *n, vtime now)
{
    return mailbox_handler_due(n, now) || n->wait.ready(n, n->wait.arg);
}

static void run_warm(struct node *n)
{
    pending_forget(n);
    n->state = NODE_COMPUTING;
    n->sys->unseen = 0;
    run(n);
    if (n->crash && n->pending.count)
        n->pending.open = false; /* it crashes in its turn */
    if (n->pending.count && n->pending.quiet && !n->wait.rests)
        turn_put(n, pending_tell(n));
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
        turn_put(n, n->ahead.arrived);
}

/* Is a node's check to come before time and place? */
static bool check_is_before(const struct node_system *s, vtime time, uint32_t place)
{
    vtime check = bounds_least(&s->checks);
    return check < time || (check == time && check != VT_NEVER && bounds_place(&s->checks) < place);
}

bool turn_is_first(struct node *n, vtime now)
{
    const struct node_system *s = n->sys;
    return evq_late_is_first(s->q, now, n->place) && !check_is_before(s, now, n->place) &&
           (!s->workers || workers_allow(s->workers, now, n->place));
}

/* A computing node has come to a call or check. */
static void arrive(struct node *n, vtime now)
{
    clock_advance_to(n, now);
    if (n->wait.ready && turn_is_first(n, now) && !n->sys->stop && now <= n->sys->max_time &&
        !may_go_on(n, now))
        turn_block(n, now);
    else
        resume(n, now);
}

/* What the program has been waiting for with nothing pending any more, or what has become of it. */
static void pending_made(struct node *n)
{
    bool drains = n->pending.drains;
    n->pending.drains = false;
    vtime turn = clock_sync(n);
    if (n->crash)
        crash(n);
    else if (drains)
        run_on(n);
    else if (n->wait.ready && turn_may_rest(n, turn) && !may_go_on(n, turn))
        n->wait.rests = true;
    else
        turn_put(n, turn);
}

/* Pending calls have their turn: the first, and those for which it is then the turn already. */
static void make_pending(struct node *n, vtime now)
{
    do {
        pending_commit(n, now);
        if (n->pending.count == 0) {
            pending_made(n);
            return;
        }
        now = pending_next(n);
    } while (now <= n->sys->max_time && turn_is_first(n, now));
    turn_put(n, now);
}

/* It is the turn of a node that computes ahead: of its call or check, or of the first of its pending calls. */
static void go_on(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    if (n->state == NODE_ENDED)
        return; /* killed meanwhile */
    vtime more = n->clock.stolen - n->clock.counted;
    n->clock.stolen = n->clock.counted = 0;
    if (more) {
        turn_put(n, now + more);
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
        turn_at_check(n, n->ahead.check, 0);
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
    if (bounds_least(&s->checks) != VT_NEVER && check_is_before(s, evq_next(s->q), evq_next_place(s->q))) {
        check(node_at(s, bounds_place(&s->checks)));
        return true;
    }
    return evq_step(s->q, &s->present);
}

static void wake(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    if (turn_rest_ends(n, n->sys->present))
        turn_put_again(n);
    if (n->state != NODE_BLOCKED)
        return;
    clock_advance_to(n, now);
    account_wait(n, now - n->wait.since, n->stats.system - n->wait.busy);
    if (may_go_on(n, now))
        resume(n, now);
    else
        turn_block(n, now);
}

void node_wake(struct node *n, vtime t)
{
    evq_put_late(n->sys->q, t, n->place, wake, n, NULL);
}

void node_start(struct node *n, vtime t)
{
    turn_put(n, t);
}

void node_cut(struct node *n, struct instant at)
{
    vtime t = at.time;
    turn_rest_ends(n, at);
    pending_take_back(n, at);
    node_catch_up(n, t);
    leave_check(n);
    vtime now = node_now(n), turn = now + n->clock.stolen;
    bool at_its_turn = n->call && now < t;
    if (n->state == NODE_BLOCKED)
        account_wait(n, t - n->wait.since, n->stats.system - n->wait.busy);
    else if (turn > t && !at_its_turn)
        clock_cut(n, turn - t);
    n->cut_short = n->state == NODE_COMPUTING;
    n->clock.stolen = n->clock.counted = 0;
}
