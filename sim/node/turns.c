/* turns.c - see turns.h. */
#include "node/turns.h"
#include <errno.h>
#include <stddef.h>
#include "kernel/cache.h"
#include "kernel/fiber.h"
#include "node/account.h"
#include "node/clock.h"
#include "node/handlers.h"
#include "node/isolate.h"
#include "node/mailbox.h"
#include "node/pending.h"
#include "node/system.h"
#include "nx_api/contract/program_image.h"

static void go_on(void *ctx, void *arg, vtime now);
static void wake(void *ctx, void *arg, vtime now);

/* Up to the node's turn now, that included. */
static struct instant up_to(const struct node *n, vtime now)
{
    return (struct instant){now, n->place + 1};
}

void turn_put(struct node *n, vtime t)
{
    evq_put_late(n->sys->q, t, n->place, go_on, n, NULL);
}

void turn_at_check(struct node *n, vtime check, vtime t)
{
    n->stopped = true;
    n->ahead.check = check;
    bounds_set(&n->sys->checks, n->place, vt_max(check, t));
}

static void leave_check(struct node *n)
{
    n->stopped = false;
    bounds_set(&n->sys->checks, n->place, VT_NEVER);
}

/* The node whose turn comes so many events after the next; NULL: unknown, or something else happens then. */
static struct node *coming(const struct node_system *s, unsigned after)
{
    evq_fire *fire;
    struct node *n = evq_coming(s->q, after, &fire);
    return fire == go_on || fire == wake ? n : NULL;
}

/* --- loading ahead (inlined: see cache.h) --- */

static inline __attribute__((always_inline)) void load(const void *from, const void *end)
{
    for (const char *p = from; p < (const char *)end; p += CACHE_LINE)
        __builtin_prefetch(p, 1);
}

/* What every program wants of its node behind the first block. */
static inline __attribute__((always_inline)) void load_node(const struct node *n)
{
    enum { CALLS = 2 };
    __builtin_prefetch((const char *)n + CACHE_BLOCK, 1);
    load(n->calls, &n->calls[CALLS]);
    load(&n->fiber.self, &n->ahead.work);
}

static uint32_t ids_in_use(const struct node *n)
{
    return n->mailbox.ids.used < IDS_BLOCK ? n->mailbox.ids.used : IDS_BLOCK;
}

/* The first ids are in use, most often. */
static inline __attribute__((always_inline)) void load_receives(const struct node *n)
{
    for (uint32_t i = 0; i < ids_in_use(n); i++)
        cache_load(&n->mailbox.ids.first->ids[i]);
    cache_load(n->receive.m);
    __builtin_prefetch(n->stats.waits.list, 1);
}

static inline __attribute__((always_inline)) void load_messages(const struct node *n)
{
    for (uint32_t i = 0; i < ids_in_use(n); i++)
        cache_load(n->mailbox.ids.first->ids[i].receive.m);
}

/* Of the stack: from a program's call to the switch, some functions. Beside its counter lie its other small variables, and
 * where it has its calls' addresses. */
static inline __attribute__((always_inline)) void load_program(const struct node *n)
{
    enum { LINE = CACHE_LINE, STACK = 7 * LINE, BESIDE = 2 * LINE };
    load((const char *)n->left - BESIDE, (const char *)n->left + BESIDE + LINE);
    const char *innermost = fiber_innermost(&n->fiber);
    load(innermost, innermost + STACK);
}

/* Looks up a page of a program: four at a time take hardly longer than one. That of its counter has its entry in the same
 * line of the page tables. */
static inline __attribute__((always_inline)) void load_page(const struct node *n)
{
    if (n && !n->loose && fiber_innermost(&n->fiber))
        __builtin_prefetch(fiber_innermost(&n->fiber), 1);
}

/* With thousands of nodes, none of what a node needs is in the caches when its turn comes. Loading begins some events ahead:
 * the node first, then what it points to. */
static inline __attribute__((always_inline)) void warm_coming(const struct node_system *s)
{
    enum { FIRST = 10, TOGETHER = 4, PAGES = 4, SECOND = 4, THIRD = 2 };
    const struct node *n = coming(s, FIRST);
    if (n)
        load_node(n);
    for (unsigned i = 0; s->switches % TOGETHER == 0 && i < TOGETHER; i++)
        load_page(coming(s, PAGES + i));
    n = coming(s, SECOND);
    if (n && !n->loose)
        load_receives(n);
    n = coming(s, THIRD);
    if (n && n->state != NODE_ENDED && !n->loose && fiber_innermost(&n->fiber)) {
        load_messages(n);
        load_program(n);
    }
}

/* --- */

/* Lets the program run on this thread until it yields. */
static void run(struct node *n)
{
    isolate_run(n);
    errno = n->saved_errno;
    fiber_resume(&n->fiber);
    if (n->crash)
        n->sys->keep_crash(n);
    clock_sync(n);
    n->saved_errno = errno;
}

/* A program has crashed, in a call, or computing: told at the time of its clock, which messages may put off as they do a call. */
static void crash(struct node *n)
{
    n->pending.open = false;
    if (!n->call)
        clock_crash(n);
    turn_put(n, node_now(n));
}

bool turn_may_rest(const struct node *n, vtime now)
{
    return !n->armed && !n->is_host && !n->loose && !n->clock.stolen && !n->sys->stop &&
           now <= n->sys->max_time && !turn_is_passed(n, now);
}

/* The turn of a program that is not loose, as far as is known. */
static vtime turn_of(struct node *n)
{
    return clock_sync(n) + n->clock.stolen;
}

void turn_settle(struct node *n, struct instant before)
{
    pending_make_until(n, before);
    if (!n->rests || n->pending.count || !instant_before(turn_of(n), n->place, before))
        return;
    n->rests = false;
    clock_advance(n, n->clock.stolen);
    n->clock.stolen = 0;
    account_block(n, clock_sync(n));
}

/* Will what the program waits for be there at its turn? */
static bool will_be_ready(struct node *n)
{
    n->clock.now += n->clock.stolen;
    bool ready = n->wait.ready(n, n->wait.arg);
    n->clock.now -= n->clock.stolen;
    return ready;
}

/* A program that rests goes on at its turn, if what it waits for is there. What it has to do in turn before is looked at
 * first: messages may put that off, and its turn with it. */
static void rouse(struct node *n)
{
    if (!n->rests || n->pending.told || !will_be_ready(n))
        return;
    n->rests = false;
    turn_put(n, turn_of(n));
}

void engine_touch(struct node *n)
{
    if (!n->stopped && !n->pending.count && !n->rests)
        return;
    struct instant at = turn_reached(n->sys);
    if (n->stopped)
        node_catch_up(n, at.time + (n->place < at.place));
    turn_settle(n, at);
}

void engine_look(struct node *n, vtime t)
{
    turn_settle(n, turn_reached(n->sys));
    rouse(n);
    vtime turn = n->loose ? n->sys->present.time + n->clock.stolen : turn_of(n);
    if (n->state == NODE_BLOCKED || turn < t)
        node_wake(n, t);
    /* else the turn of the program, which has been stopped, will not come before */
}

static void in_turn(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    pending_make_until(n, up_to(n, now));
    if (n->pending.told != now)
        return;
    n->pending.told = 0;
    turn_tell(n);
    rouse(n);
}

void turn_tell(struct node *n)
{
    struct message *sends;
    vtime turn = pending_turn(n, &sends);
    if (turn == VT_NEVER || (n->pending.told && n->pending.told <= turn))
        return;
    n->pending.told = turn;
    evq_put_late(n->sys->q, turn, n->place, in_turn, n, sends);
}

/* Has the program, which waits, anything to do now? */
static bool may_go_on(struct node *n, vtime now)
{
    return handlers_due(n, now) || n->wait.ready(n, n->wait.arg);
}

static void run_warm(struct node *n)
{
    n->state = NODE_COMPUTING;
    n->sys->unseen = 0;
    run(n);
    if (n->crash)
        crash(n);
    else if (n->loose)
        workers_hand(n->sys->workers, &n->ahead.work);
}

static void run_on(struct node *n)
{
    n->sys->switches++;
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
    load(n, (const char *)n + CACHE_BLOCK);
    load_node(n);
    load_program(n);
    run(n);
    return n->crash || !n->ahead.paused;
}

void node_catch(struct node *n)
{
    n->loose = false;
    n->ahead.up_to = 0;
    if (n->crash)
        crash(n);
    else
        node_yield_turn(n, n->ahead.arrived);
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
        account_block(n, now);
    else
        resume(n, now);
}

/* It is the turn of a node that computes ahead: of its call or check. */
static void go_on(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    if (n->state == NODE_ENDED)
        return; /* killed meanwhile */
    pending_make_until(n, up_to(n, now));
    vtime turn = !n->pending.drains ? turn_of(n) : n->pending.count ? pending_last(n) : now;
    if (turn > now) {
        turn_put(n, turn);
    } else if (n->crash) {
        n->clock.stolen = 0;
        clock_advance_to(n, now);
        n->sys->crashed(n);
    } else if (n->pending.drains) {
        n->pending.drains = false;
        run_on(n);
    } else {
        n->clock.stolen = 0;
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
    run_warm(n);
}

void node_catch_up(struct node *n, vtime t)
{
    if (!n->stopped)
        return;
    if (n->ahead.check < t && !n->clock.stolen) {
        struct node *caller = isolate_keep(n->sys);
        n->ahead.up_to = t;
        check(n);
        n->ahead.up_to = 0;
        isolate_back_to(n->sys, caller);
    }
    if (n->stopped)
        turn_at_check(n, n->ahead.check, 0);
}

/* --- programs that have stopped at checks, on any thread --- */

/* A thread is worth what takes half as long as the longest time between looks: some microseconds of ours. */
#define WORTH_LENDING (UINT64_C(160000) * NXC_UNITS_PER_CLOCK)

/* Does it compute so many units at least before it makes a call, or anything reaches it, if no check comes before `bound`? */
static bool may_lend(const struct node *n, vtime bound, uint64_t units)
{
    const struct node_system *s = n->sys;
    vtime then = n->ahead.check + clock_of_units(n, units);
    return s->checks.time[n->place] >= then && !n->clock.stolen && !n->in_handler &&
           proto_horizon(s->proto, n->place, bound) >= then;
}

static void lend(struct node *n, vtime bound)
{
    const struct node_system *s = n->sys;
    n->ahead.up_to = vt_min(s->checks.time[n->place], proto_horizon(s->proto, n->place, bound));
    leave_check(n);
    n->loose = true;
    n->ahead.work.place = n->place;
    atomic_store_explicit(&n->ahead.work.reached, n->ahead.check, memory_order_relaxed);
    workers_hand(s->workers, &n->ahead.work);
}

/* The next that has so many units to compute at least, from a place on, which becomes the one behind it. NULL: there is none. */
static struct node *next_to_lend(const struct node_system *s, uint32_t *place, vtime bound, uint64_t units)
{
    while (*place < s->checks.room) {
        uint32_t at = (*place)++;
        struct node *n = s->checks.time[at] != VT_NEVER ? node_at(s, at) : NULL;
        if (n && may_lend(n, bound, units))
            return n;
    }
    return NULL;
}

/* Are there two? One alone finds nothing to run beside. */
static bool is_worth_lending(const struct node_system *s, vtime bound)
{
    uint32_t place = 0;
    return next_to_lend(s, &place, bound, WORTH_LENDING) && next_to_lend(s, &place, bound, WORTH_LENDING);
}

/* The next check is n's. If it has far to compute until there, others may have, too: they all go on at once. */
static bool lend_all(struct node *n)
{
    struct node_system *s = n->sys;
    if (!s->workers)
        return false;
    vtime bound = bounds_least(&s->checks);
    bool worth = may_lend(n, bound, WORTH_LENDING) && is_worth_lending(s, bound), any = false;
    if (!workers_worth(s->workers, worth))
        return false;
    uint32_t place = 0;
    while ((n = next_to_lend(s, &place, bound, worth ? WORTH_LENDING : 1)))
        lend(n, bound), any = true;
    return any;
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
        struct node *n = node_at(s, bounds_place(&s->checks));
        if (!lend_all(n))
            check(n);
        return true;
    }
    s->reached = turn_reached(s);
    return evq_step(s->q, &s->present);
}

static void wake(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    turn_settle(n, turn_reached(n->sys));
    rouse(n);
    if (n->state == NODE_BLOCKED && account_unblock(n, now))
        run_on(n);
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
    if (n->loose && n->sys->workers)
        workers_drop(n->sys->workers, &n->ahead.work);
    n->loose = false;
    n->ahead.up_to = 0;
    turn_settle(n, instant_later(at, turn_reached(n->sys)));
    n->rests = false;
    pending_take_back(n);
    node_catch_up(n, at.time);
    leave_check(n);
    vtime turn = node_now(n) + n->clock.stolen;
    if (n->state == NODE_BLOCKED)
        account_cut(n, at.time);
    else if (turn > at.time)
        clock_cut(n, turn - at.time);
    n->cut_short = n->state == NODE_COMPUTING;
    n->clock.stolen = 0;
}

void engine_settle(struct node *n, struct instant end)
{
    turn_settle(n, instant_later(end, turn_reached(n->sys)));
    if (n->state != NODE_ENDED)
        pending_take_back(n);
}

void engine_forget(struct node *n)
{
    pending_unmake(n);
}
