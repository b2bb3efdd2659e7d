/* turns.c - see turns.h. */
#include "node/turns.h"
#include <errno.h>
#include <stddef.h>
#include "kernel/cache.h"
#include "kernel/fiber.h"
#include "node/clock.h"
#include "node/cpu.h"
#include "node/mailbox.h"
#include "node/pending.h"
#include "node/system.h"
#include "nx_api/nxcc/image.h"

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
    errno = n->saved_errno;
    fiber_resume(&n->fiber);
    if (n->crash)
        n->sys->keep_crash(n);
    clock_sync(n);
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

/* A program has crashed somewhere before its next look, however far it was let run. In a call that is in its turn. */
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
    if (beside)
        n->stats.system -= beside, n->stats.beside += beside;
    n->stats.idle += idle;
    if (idle)
        waits_add(&n->stats.waits, n->call, n->awaits, n->awaited, idle);
}

void turn_block(struct node *n, vtime now)
{
    n->state = NODE_BLOCKED;
    n->blocked.since = now;
    n->blocked.busy = n->stats.system;
}

bool turn_may_rest(const struct node *n, vtime now)
{
    return !n->armed && !n->is_host && !n->loose && !n->clock.stolen && !n->sys->stop &&
           now <= n->sys->max_time;
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
    turn_block(n, clock_sync(n));
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

void turn_look(struct node *n, vtime t)
{
    turn_settle(n, n->sys->present);
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
    return mailbox_handler_due(n, now) || n->wait.ready(n, n->wait.arg);
}

static void run_warm(struct node *n)
{
    n->state = NODE_COMPUTING;
    n->sys->unseen = 0;
    run(n);
    if (n->crash)
        n->pending.open = false;
    if (n->crash && n->pending.count)
        turn_put(n, pending_last(n)); /* it crashes behind them, or in the last */
    else if (n->crash)
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
        turn_block(n, now);
    else
        resume(n, now);
}

/* The turn of a program that goes on to compute, or crashes, when nothing is pending any more. */
static vtime turn_behind_pending(const struct node *n, vtime now)
{
    return n->pending.count ? pending_last(n) : now;
}

/* It is the turn of a node that computes ahead: of its call or check. */
static void go_on(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    if (n->state == NODE_ENDED)
        return; /* killed meanwhile */
    pending_make_until(n, up_to(n, now));
    bool behind = n->pending.drains || n->crash;
    vtime turn = behind ? turn_behind_pending(n, now) : turn_of(n);
    if (turn > now) {
        turn_put(n, turn);
    } else if (n->crash) {
        crash(n);
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
        n->ahead.up_to = t;
        check(n);
        n->ahead.up_to = 0;
    }
    if (n->stopped)
        turn_at_check(n, n->ahead.check, 0);
}

void node_catch_up_now(struct node *n)
{
    const struct node_system *s = n->sys;
    node_catch_up(n, s->present.time + (n->place < s->present.place));
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
    return evq_step(s->q, &s->present);
}

static void wake(void *ctx, void *arg, vtime now)
{
    struct node *n = ctx;
    (void)arg;
    turn_settle(n, n->sys->present);
    rouse(n);
    if (n->state != NODE_BLOCKED)
        return;
    clock_advance_to(n, now);
    account_wait(n, now - n->blocked.since, n->stats.system - n->blocked.busy);
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
    turn_settle(n, at);
    n->rests = false;
    pending_take_back(n);
    node_catch_up(n, t);
    leave_check(n);
    vtime now = node_now(n), turn = now + n->clock.stolen;
    bool at_its_turn = n->call && now < t;
    if (n->state == NODE_BLOCKED)
        account_wait(n, t - n->blocked.since, n->stats.system - n->blocked.busy);
    else if (turn > t && !at_its_turn)
        clock_cut(n, turn - t);
    n->cut_short = n->state == NODE_COMPUTING;
    n->clock.stolen = 0;
}
