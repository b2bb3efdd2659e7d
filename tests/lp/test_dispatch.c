/* Logical processes without an operating system: commit times, blocking, polls, stolen time, roll back.
 *
 * The programs are C functions on fibers. This file implements lp/upcalls.h for them, instead of sim/os. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "lp/block.h"
#include "lp/clock.h"
#include "lp/deferral.h"
#include "lp/dispatch.h"
#include "lp/engine.h"
#include "lp/lookahead.h"
#include "lp/offload.h"
#include "lp/upcalls.h"
#include "net/endpoint.h"

enum { NODES = 8, MOST_LOG = 4096, STACK = 1 << 17 };
#define US VT_MICROSECOND
/* At 40 MHz. */
#define UNITS_PER_US (UINT64_C(40) * NXC_UNITS_PER_CLOCK)

/* A sender spends 35 us on a message; it arrives when it leaves. So nothing reaches a node sooner than 35 us
 * after an event, but what is on its way already. */
static const struct cfg_machine CFG = {
    .short_limit = 100, .short_send_ps = 35 * US, .forced_send_ps = 45 * US, .ask_send_ps = 40 * US};

/* What is committed: calls, messages, deferred calls, crashes, ends. */
struct entry {
    vtime time;
    uint32_t address;
    char what;
};

struct fake_machine {
    struct schedule s; /* first */
    struct fake_node *node[NODES];
    struct entry log[MOST_LOG];
    size_t log_count;
    vtime system; /* of each message */
};

struct fake_node {
    struct lp lp; /* first */
    struct fake_machine *m;
    void (*program)(struct fake_node *n);
    int64_t budget, lookahead;
    bool interruptible, states_lookahead, crashes;
    bool waits;       /* in lp_yield, for what is there from `ready` on */
    vtime ready;      /* VT_NEVER: unknown */
    vtime deferred;   /* commit time of a deferred call; 0: none */
    bool needs_event; /* it */
    uint64_t deferred_units;
    vtime idle;
    uint64_t random;
    char *stack;
};

static struct fake_node *node_of(const struct lp *lp)
{
    return (struct fake_node *)lp;
}

static void note(struct fake_node *n, vtime time, char what)
{
    struct fake_machine *m = n->m;
    assert_true(m->log_count < MOST_LOG);
    m->log[m->log_count++] = (struct entry){time, n->lp.address, what};
}

/* --- lp/upcalls.h --- */

struct lp *up_lp_at(struct schedule *s, uint32_t address)
{
    return &((struct fake_machine *)s)->node[address]->lp;
}

bool up_has_deferred(const struct lp *lp)
{
    return node_of(lp)->deferred;
}

void up_commit_deferred(struct lp *lp, struct instant before)
{
    struct fake_node *n = node_of(lp);
    vtime t = n->deferred + lp->clock.stolen;
    if (!n->deferred || !instant_before(t, lp->address, before))
        return;
    clock_add_stolen(lp);
    n->deferred = 0;
    note(n, t, 'd');
}

vtime up_next_deferred(const struct lp *lp, void **sends)
{
    const struct fake_node *n = node_of(lp);
    *sends = NULL;
    return n->deferred && n->needs_event ? n->deferred + lp->clock.stolen : VT_NEVER;
}

vtime up_last_deferred(const struct lp *lp)
{
    return node_of(lp)->deferred + lp->clock.stolen;
}

void up_deferred_may_select(struct lp *lp)
{
    node_of(lp)->needs_event = true;
    lp_schedule_deferred(lp);
}

void up_roll_back_deferred(struct lp *lp)
{
    struct fake_node *n = node_of(lp);
    if (n->deferred)
        clock_return_to(lp, n->deferred_units, n->deferred);
    n->deferred = 0;
}

void up_drop_deferred(struct lp *lp)
{
    node_of(lp)->deferred = 0;
}

bool up_is_interruptible(const struct lp *lp)
{
    return node_of(lp)->interruptible;
}

bool up_in_handler(const struct lp *lp)
{
    (void)lp;
    return false;
}

vtime up_next_interrupt(const struct lp *lp)
{
    (void)lp;
    return VT_NEVER;
}

bool up_may_resume(struct lp *lp, vtime now)
{
    return !node_of(lp)->waits || node_of(lp)->ready <= now;
}

void up_wait_begins(struct lp *lp)
{
    (void)lp;
}

void up_wait_ends(struct lp *lp, vtime t)
{
    node_of(lp)->idle += t - lp->blocked_since;
}

void up_program_resumes(struct lp *lp)
{
    (void)lp;
}

bool up_program_returns(struct lp *lp)
{
    return node_of(lp)->crashes;
}

void up_report_crash(struct lp *lp)
{
    note(node_of(lp), lp->clock.now, 'x');
    lp_end(lp);
}

void *up_nest(struct schedule *s)
{
    (void)s;
    return NULL;
}

void up_unnest(struct schedule *s, void *outer)
{
    (void)s, (void)outer;
}

void up_end_at_limit(struct schedule *s)
{
    schedule_stop(s, STOP_VIRTUAL_TIME, (struct instant){s->max_time, UINT32_MAX});
}

void up_prefetch_node(const struct lp *lp)
{
    (void)lp;
}

void up_prefetch_receives(const struct lp *lp)
{
    (void)lp;
}

void up_prefetch_messages(const struct lp *lp)
{
    (void)lp;
}

void up_prefetch_program(const struct lp *lp)
{
    (void)lp;
}

/* --- messages --- */

/* A message reaches the node: so much of its processor's time, and what its program waits for. */
void endpoint_arrived(void *ctx, struct message *message, vtime now)
{
    struct fake_machine *m = ctx;
    struct fake_node *n = m->node[message->to];
    protocol_message_free(message);
    lp_synchronise(&n->lp);
    note(n, now, 'm');
    if (lp_computes(&n->lp))
        clock_steal(&n->lp, m->system);
    n->ready = vt_min(n->ready, now + m->system);
    lp_notify(&n->lp, now + m->system);
}

bool endpoint_envelope(void *ctx, struct message *message, vtime now)
{
    (void)ctx, (void)message, (void)now;
    return true;
}

/* Sends one that leaves at t, and arrives then. */
static void send_at(struct fake_machine *m, vtime t, uint32_t from, uint32_t to)
{
    protocol_send(m->s.protocol, protocol_message(m->s.protocol, from, to, 0, 0, NULL, 0), t);
}

static void message_at(struct fake_machine *m, vtime t, uint32_t to)
{
    send_at(m, t, NODES - 1, to);
}

/* --- what programs call, on their fibers --- */

static void order(struct fake_node *n)
{
    struct lp *lp = &n->lp;
    vtime now = clock_sync(lp);
    while (up_has_deferred(lp) || lp_must_yield(lp, now)) {
        lp_prepare_yield(lp, now);
        lp_yield(lp);
        now = clock_sync(lp);
    }
    lp_commit(lp, now);
}

static void leave(struct fake_node *n)
{
    clock_sync(&n->lp);
    clock_begin_segment(&n->lp);
    clock_allow(&n->lp, lp_deadline(&n->lp));
    offload_at_leave(&n->lp);
}

/* nxc_preempt; the program has so many units left to compute before its next call. */
static void poll(struct fake_node *n, uint64_t left)
{
    struct lp *lp = &n->lp;
    if (n->states_lookahead)
        n->lookahead = n->budget - (int64_t)left;
    vtime now = clock_sync(lp);
    clock_take_lookahead(lp);
    clock_reach_boundary(lp, 1);
    if (lp->interruptible && !(lp->state == LP_OFFLOADED && now < lp->until))
        order(n);
    else if (now > lp->schedule->max_time)
        order(n);
    else
        offload_at_poll(lp, now);
    clock_allow(lp, lp->state == LP_OFFLOADED && !lp->interruptible ? schedule_end_of_time(lp->schedule)
                                                                    : lp_deadline(lp));
}

/* With a poll each microsecond. */
static void compute(struct fake_node *n, vtime us)
{
    for (; us > 0; us--) {
        n->budget -= UNITS_PER_US;
        if (n->budget < 0)
            poll(n, (us - 1) * UNITS_PER_US);
    }
}

static void enter(struct fake_node *n)
{
    clock_stop(&n->lp);
    offload_note_segment(&n->lp, "call");
}

static void call(struct fake_node *n)
{
    enter(n);
    order(n);
    note(n, n->lp.clock.now, 'c');
    leave(n);
}

static void call_and_send(struct fake_node *n, uint32_t to)
{
    enter(n);
    order(n);
    note(n, n->lp.clock.now, 'c');
    clock_advance(&n->lp, CFG.short_send_ps);
    if (to != n->lp.address)
        send_at(n->m, n->lp.clock.now, n->lp.address, to);
    leave(n);
}

/* Returns when what it waits for is there; lazily blocked if possible. */
static void wait_for_message(struct fake_node *n, bool lazily)
{
    struct lp *lp = &n->lp;
    enter(n);
    vtime now = clock_sync(lp);
    bool yields = lp_must_yield(lp, now);
    lp_begin_wait(lp);
    n->waits = true;
    if (yields) {
        if (lazily && n->ready > now && lp_may_block_lazily(lp, now))
            lp_block_lazily(lp);
        else
            lp_prepare_yield(lp, now);
        lp_yield(lp);
        if (lp->blocked_since == VT_NEVER)
            order(n);
    } else {
        lp_commit(lp, now);
    }
    if (n->ready > clock_sync(lp)) {
        lp_block(lp, lp->clock.now);
        lp_yield(lp);
    }
    n->waits = false, n->ready = VT_NEVER;
    note(n, lp->clock.now, 'r');
    leave(n);
}

/* A call that the program leaves before it is committed. */
static void defer(struct fake_node *n, bool needs_event)
{
    n->deferred = clock_stop(&n->lp);
    n->deferred_units = n->lp.clock.units;
    n->needs_event = needs_event;
    lp_schedule_deferred(&n->lp);
    leave(n);
}

/* --- machines --- */

static void run_program(void *arg)
{
    struct fake_node *n = arg;
    leave(n);
    n->program(n);
    enter(n);
    order(n);
    note(n, n->lp.clock.now, 'e');
    lp_end(&n->lp);
    fiber_finish(&n->lp.fiber);
}

static void look(void *ctx)
{
    (void)ctx;
}

vtime endpoint_work(void *ctx, uint32_t node, enum protocol_task task, vtime at, vtime t)
{
    (void)ctx, (void)node, (void)task;
    return at + t;
}

void endpoint_pio(void *ctx, uint32_t node, enum protocol_task task, vtime at, vtime t)
{
    (void)ctx, (void)node, (void)task, (void)at, (void)t;
}

void endpoint_sent(void *ctx, struct message *m, vtime now)
{
    (void)ctx, (void)m, (void)now;
}

static struct fake_machine *machine(void)
{
    struct fake_machine *m = calloc(1, sizeof *m);
    struct topo topo;
    m->s = (struct schedule){.q = evq_new(), .max_time = VT_NEVER, .look = look};
    assert_true(topo_hypercube(&topo, NODES, 3));
    m->s.protocol = protocol_new(&CFG, &topo, m->s.q, m);
    return m;
}

static struct fake_node *add(struct fake_machine *m, uint32_t address, void (*program)(struct fake_node *n))
{
    struct fake_node *n = m->node[address] = calloc(1, sizeof *n);
    n->m = m, n->program = program, n->ready = VT_NEVER, n->random = address;
    n->stack = malloc(STACK);
    lp_begin(&n->lp, &m->s, address);
    clock_set(&n->lp, 40000000);
    lp_bind(&n->lp, &n->budget, &n->lookahead);
    fiber_begin(&n->lp.fiber, n->stack, STACK, run_program, n);
    lp_start(&n->lp, 0);
    return n;
}

static void *begin_thread(void)
{
    return NULL;
}

static void end_thread(void *own)
{
    (void)own;
}

static void run_with(struct fake_machine *m, unsigned threads, uint64_t shuffle)
{
    engine_run(&m->s, &(struct engine_threads){threads, shuffle, begin_thread, end_thread, NULL, NULL});
}

static void run(struct fake_machine *m)
{
    run_with(m, 1, 0);
}

static void end(struct fake_machine *m)
{
    for (int i = 0; i < NODES; i++)
        if (m->node[i]) {
            fiber_end(&m->node[i]->lp.fiber);
            free(m->node[i]->stack);
            lp_unbind(&m->node[i]->lp);
            free(m->node[i]);
        }
    protocol_free(m->s.protocol);
    evq_free(m->s.q);
    mintree_free(&m->s.polls);
    free(m);
}

/* Is this all that was committed, in this order? Text: "time in us, what, address", in turn. */
static void assert_log(const struct fake_machine *m, const char *expected)
{
    char text[4096] = "", *at = text;
    for (size_t i = 0; i < m->log_count; i++)
        at += snprintf(at, (size_t)(text + sizeof text - at), "%s%.9g%c%u", i ? " " : "",
                       (double)m->log[i].time / (double)US, m->log[i].what, m->log[i].address);
    assert_string_equal(text, expected);
}

/* --- the total order --- */

static void calls_after_20_and_50(struct fake_node *n)
{
    compute(n, 20), call(n), compute(n, 30), call(n);
}

static void calls_after_30_and_40(struct fake_node *n)
{
    compute(n, 30), call(n), compute(n, 10), call(n);
}

static void calls_are_committed_in_the_order_of_time_then_address(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    add(m, 2, calls_after_20_and_50);
    add(m, 0, calls_after_30_and_40);
    add(m, 1, calls_after_20_and_50);
    run(m);
    assert_log(m, "20c1 20c2 30c0 40c0 40e0 50c1 50e1 50c2 50e2");
    end(m);
}

static void two_calls_in_no_time(struct fake_node *n)
{
    compute(n, 20), call(n), call(n);
}

static void calls_in_no_time_are_one_nodes_before_the_next(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    add(m, 1, two_calls_in_no_time);
    add(m, 0, two_calls_in_no_time);
    run(m);
    assert_log(m, "20c0 20c0 20e0 20c1 20c1 20e1");
    end(m);
}

/* --- waiting --- */

static void waits_after_10(struct fake_node *n)
{
    compute(n, 10), wait_for_message(n, false);
}

static void waits_lazily_after_10(struct fake_node *n)
{
    compute(n, 10), wait_for_message(n, true);
}

static void waits_after_500(struct fake_node *n)
{
    compute(n, 500), wait_for_message(n, false);
}

static void waits_lazily_after_500(struct fake_node *n)
{
    compute(n, 500), wait_for_message(n, true);
}

static void wake_only(void *ctx, void *arg, vtime now)
{
    struct fake_node *n = ctx;
    (void)arg;
    assert_int_equal(n->lp.state, LP_BLOCKED);
    assert_int_equal(n->lp.clock.now, 10 * US); /* it stands still, however often the node is asked */
    lp_wake(&n->lp, now);
}

static void a_blocked_node_resumes_only_when_what_it_waits_for_is_there(void **state)
{
    struct fake_machine *m = machine();
    struct fake_node *n = add(m, 1, waits_after_10);
    (void)state;
    add(m, 0, calls_after_30_and_40);
    evq_put(m->s.q, 50 * US, 1, wake_only, n, NULL);
    evq_put(m->s.q, 60 * US, 1, wake_only, n, NULL);
    message_at(m, 100 * US, 1);
    run(m);
    assert_log(m, "30c0 40c0 40e0 100m1 100r1 100e1");
    assert_int_equal(n->idle, 90 * US);
    end(m);
}

static void a_node_that_nothing_reaches_stays_blocked(void **state)
{
    struct fake_machine *m = machine();
    struct fake_node *n = add(m, 1, waits_after_10);
    (void)state;
    run(m);
    assert_log(m, "");
    assert_int_equal(n->lp.state, LP_BLOCKED);
    assert_int_equal(n->lp.clock.now, 10 * US);
    end(m);
}

static void expect_lazily_blocked(void *ctx, void *arg, vtime now)
{
    struct fake_node *n = ctx;
    (void)arg, (void)now;
    assert_int_equal(n->lp.state, LP_BLOCKS_LAZILY);
    assert_true(evq_next(n->m->s.q) > 40 * US);
}

static void a_lazily_blocked_node_has_no_event_and_is_blocked_when_a_message_comes(void **state)
{
    struct fake_machine *m = machine();
    struct fake_node *n = add(m, 0, waits_lazily_after_10);
    (void)state;
    evq_put(m->s.q, 1 * US, 1, expect_lazily_blocked, n, NULL);
    message_at(m, 100 * US, 0);
    run(m);
    assert_log(m, "100m0 100r0 100e0");
    assert_int_equal(n->idle, 90 * US);
    end(m);
}

static void a_lazily_blocked_node_resumes_at_its_commit_time_if_the_message_came_before(void **state)
{
    struct fake_machine *m = machine();
    struct fake_node *n = add(m, 0, waits_lazily_after_500);
    (void)state;
    message_at(m, 100 * US, 0);
    run(m);
    assert_log(m, "100m0 500r0 500e0");
    assert_int_equal(n->idle, 0);
    assert_int_equal(n->lp.blocked_since, VT_NEVER);
    end(m);
}

static void a_node_woken_before_its_commit_time_asks_then(void **state)
{
    struct fake_machine *m = machine();
    struct fake_node *n = add(m, 0, waits_after_500);
    (void)state;
    message_at(m, 100 * US, 0);
    run(m);
    assert_log(m, "100m0 500r0 500e0");
    assert_int_equal(n->idle, 0);
    end(m);
}

static void tell_of_later(void *ctx, void *arg, vtime now)
{
    struct fake_node *n = ctx;
    (void)arg, (void)now;
    n->ready = 600 * US;
    lp_notify(&n->lp, n->ready);
}

static void a_node_notified_of_later_than_its_commit_time_resumes_then(void **state)
{
    (void)state;
    for (int lazily = 0; lazily < 2; lazily++) {
        struct fake_machine *m = machine();
        struct fake_node *n = add(m, 0, lazily ? waits_lazily_after_500 : waits_after_500);
        evq_put(m->s.q, 100 * US, 0, tell_of_later, n, NULL);
        run(m);
        assert_log(m, "600r0 600e0");
        assert_int_equal(n->idle, 100 * US);
        end(m);
    }
}

static void waits_twice_in_no_time(struct fake_node *n)
{
    wait_for_message(n, false);
    vtime now = clock_sync(&n->lp);
    assert_true(lp_is_passed(&n->lp, now));
    assert_false(lp_may_block_lazily(&n->lp, now));
    assert_false(lp_is_passed(&n->lp, now + 1));
    assert_true(lp_may_block_lazily(&n->lp, now + 1));
}

static void wake_node_0(void *ctx, void *arg, vtime now)
{
    struct fake_machine *m = ctx;
    (void)arg;
    m->node[0]->ready = now;
    lp_notify(&m->node[0]->lp, now);
}

static void a_moment_that_the_machine_has_passed_gets_an_event(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    add(m, 0, waits_twice_in_no_time);
    evq_put(m->s.q, 20 * US, 3, wake_node_0, m, NULL); /* at 20 us the machine comes back from 3 to 0 */
    run(m);
    assert_log(m, "20r0 20e0");
    assert_int_equal(m->s.reached.address, 3);
    end(m);
}

/* --- stolen time --- */

static void calls_after_500(struct fake_node *n)
{
    compute(n, 500), call(n);
}

static void calls_after_505(struct fake_node *n)
{
    compute(n, 505), call(n);
}

static void stolen_time_puts_commit_times_off(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    m->system = 7 * US;
    add(m, 0, calls_after_500);
    add(m, 1, calls_after_505);
    message_at(m, 100 * US, 0);
    run(m);
    assert_log(m, "100m0 505c1 505e1 507c0 507e0");
    end(m);
}

static void what_is_stolen_while_a_commit_is_put_off_puts_it_off_again(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    m->system = 7 * US;
    add(m, 0, calls_after_500);
    message_at(m, 100 * US, 0);
    message_at(m, 506 * US, 0);
    message_at(m, 515 * US, 0); /* too late */
    run(m);
    assert_log(m, "100m0 506m0 514c0 514e0 515m0");
    end(m);
}

static void a_lazily_blocked_node_is_blocked_later_by_what_is_stolen(void **state)
{
    struct fake_machine *m = machine();
    struct fake_node *n = add(m, 0, waits_lazily_after_500);
    (void)state;
    m->system = 7 * US;
    message_at(m, 100 * US, 0);
    run(m);
    assert_log(m, "100m0 507r0 507e0");
    assert_int_equal(n->idle, 0);
    end(m);
}

static void what_a_node_waits_for_may_come_in_the_time_stolen_before_its_commit(void **state)
{
    struct fake_machine *m = machine();
    struct fake_node *n = add(m, 0, waits_lazily_after_500);
    (void)state;
    m->system = 7 * US;
    message_at(m, 497 * US, 0); /* is there from 504 us on */
    run(m);
    assert_log(m, "497m0 507r0 507e0");
    assert_int_equal(n->idle, 0);
    end(m);
}

static void has_time_stolen_in_its_call(struct fake_node *n)
{
    compute(n, 20), enter(n);
    order(n);
    clock_steal(&n->lp, 7 * US);
    leave(n), compute(n, 30), call(n);
}

static void what_is_stolen_in_its_own_call_puts_a_programs_next_call_off(void **state)
{
    (void)state;
    for (int interruptible = 0; interruptible < 2; interruptible++) {
        struct fake_machine *m = machine();
        add(m, 0, has_time_stolen_in_its_call)->interruptible = interruptible;
        run(m);
        assert_log(m, "57c0 57e0");
        end(m);
    }
}

/* --- polls --- */

/* An interruptible program computes up to its horizon only. */
static void check_horizon(void *ctx, void *arg, vtime now)
{
    struct fake_node *n = ctx;
    (void)arg;
    assert_int_equal(n->lp.state, LP_PAUSED);
    assert_true(n->lp.clock.now >= now && n->lp.clock.now <= now + 35 * US);
}

static void a_program_paused_at_a_poll_is_gone_on_with_when_all_others_have_come_so_far(void **state)
{
    struct fake_machine *m = machine();
    struct fake_node *n = add(m, 0, calls_after_500);
    (void)state;
    n->interruptible = true;
    for (vtime t = 10; t < 460; t += 30)
        evq_put(m->s.q, t * US, 7, check_horizon, n, NULL);
    add(m, 1, calls_after_30_and_40);
    run(m);
    assert_log(m, "30c1 40c1 40e1 500c0 500e0");
    end(m);
}

static void two_paused_programs_wait_for_each_other(void **state)
{
    (void)state;
    for (int limited = 0; limited < 2; limited++) {
        struct fake_machine *m = machine();
        m->s.max_time = limited ? VT_MILLISECOND : VT_NEVER;
        add(m, 0, calls_after_500)->interruptible = true;
        add(m, 1, calls_after_505)->interruptible = true;
        run(m);
        assert_log(m, "500c0 500e0 505c1 505e1");
        end(m);
    }
}

/* The program is paused at the first poll past its first horizon; after it has caught up, at the first at or
 * past the present time. */
static void check_catching_up(void *ctx, void *arg, vtime now)
{
    struct fake_node *n = ctx;
    (void)arg;
    assert_int_equal(n->lp.state, LP_PAUSED);
    assert_true(n->lp.clock.now < now);
    lp_synchronise(&n->lp);
    assert_int_equal(n->lp.state, LP_PAUSED);
    assert_int_equal(n->lp.clock.now, now + US / 2);
}

static void a_paused_program_catches_up_when_a_message_comes_before(void **state)
{
    struct fake_machine *m = machine();
    struct fake_node *n = add(m, 0, calls_after_500);
    (void)state;
    n->interruptible = n->states_lookahead = true;
    m->system = 7 * US;
    add(m, 1, calls_after_30_and_40);
    evq_put(m->s.q, 200 * US + US / 2, 0, check_catching_up, n, NULL);
    message_at(m, 220 * US, 0);
    run(m);
    assert_log(m, "30c1 40c1 40e1 220m0 507c0 507e0");
    end(m);
}

static void calls_after_200(struct fake_node *n)
{
    compute(n, 200), call(n);
}

static void check_poll_at_200(void *ctx, void *arg, vtime now)
{
    struct fake_node *n = ctx;
    (void)arg, (void)now;
    assert_true(n->lp.state == LP_PAUSED && n->lp.clock.now < 50 * US);
    assert_int_equal(mintree_least(&n->m->s.polls), 200 * US);
}

static void nobody_waits_for_a_paused_program_within_its_lookahead(void **state)
{
    struct fake_machine *m = machine();
    struct fake_node *n = add(m, 0, calls_after_200);
    (void)state;
    n->interruptible = n->states_lookahead = true;
    evq_put(m->s.q, 1 * US, 7, check_poll_at_200, n, NULL);
    run(m);
    assert_log(m, "200c0 200e0");
    end(m);
}

/* --- deferred calls --- */

static void defers_at_20_and_calls_at_50(struct fake_node *n)
{
    compute(n, 20), defer(n, n->random), compute(n, 30), call(n);
}

static void a_deferred_call_with_an_event_is_committed_in_the_order_of_all(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    add(m, 1, defers_at_20_and_calls_at_50);
    add(m, 0, calls_after_30_and_40);
    add(m, 2, calls_after_20_and_50);
    run(m);
    assert_log(m, "20d1 20c2 30c0 40c0 40e0 50c1 50e1 50c2 50e2");
    end(m);
}

static void a_deferred_call_without_an_event_is_committed_before_anything_reaches_the_node(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    add(m, 0, defers_at_20_and_calls_at_50)->random = 0;
    add(m, 1, calls_after_30_and_40);
    message_at(m, 15 * US, 0);
    message_at(m, 35 * US, 0);
    run(m);
    assert_log(m, "15m0 30c1 20d0 35m0 40c1 40e1 50c0 50e0");
    end(m);
}

static void defers_at_20_and_drains(struct fake_node *n)
{
    compute(n, 20), defer(n, false), compute(n, 30);
    clock_sync(&n->lp);
    lp_drain(&n->lp);
    assert_false(up_has_deferred(&n->lp));
    compute(n, 10), call(n);
}

static void a_program_that_drains_goes_on_when_its_deferred_calls_are_committed(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    add(m, 0, defers_at_20_and_drains);
    add(m, 1, calls_after_20_and_50);
    run(m);
    assert_log(m, "20d0 20c1 50c1 50e1 60c0 60e0");
    end(m);
}

/* --- ends --- */

static bool was_computing;
static uint64_t units_left;

static void kill(void *ctx, void *arg, vtime now)
{
    struct fake_node *n = ctx;
    (void)arg;
    was_computing = lp_roll_back(&n->lp, (struct instant){now, n->lp.address});
    units_left = n->lp.clock.units;
    lp_end(&n->lp);
}

static struct fake_node *run_and_kill(struct fake_machine *m, void (*program)(struct fake_node *n), vtime at)
{
    struct fake_node *n = add(m, 1, program);
    evq_put(m->s.q, at, 1, kill, n, NULL);
    return n;
}

static void roll_back_takes_computing_back_to_the_moment(void **state)
{
    (void)state;
    for (int interruptible = 0; interruptible < 2; interruptible++) {
        struct fake_machine *m = machine();
        run_and_kill(m, calls_after_500, 200 * US)->interruptible = interruptible;
        add(m, 0, calls_after_505);
        run(m);
        assert_log(m, "505c0 505e0");
        assert_true(was_computing);
        assert_int_equal(units_left, 200 * UNITS_PER_US);
        end(m);
    }
}

static void roll_back_takes_stolen_time_off_what_was_computed(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    m->system = 7 * US;
    run_and_kill(m, calls_after_500, 200 * US);
    message_at(m, 100 * US, 1);
    run(m);
    assert_log(m, "100m1");
    assert_int_equal(units_left, 193 * UNITS_PER_US);
    end(m);
}

static void roll_back_takes_back_deferred_calls_that_are_not_committed(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    struct fake_node *n = run_and_kill(m, defers_at_20_and_calls_at_50, 15 * US);
    run(m);
    assert_log(m, "");
    assert_int_equal(n->deferred, 0);
    assert_int_equal(units_left, 15 * UNITS_PER_US);
    end(m);
}

static void a_blocked_node_has_idled_until_it_is_killed(void **state)
{
    (void)state;
    for (int lazily = 0; lazily < 2; lazily++) {
        struct fake_machine *m = machine();
        struct fake_node *n = run_and_kill(m, lazily ? waits_lazily_after_10 : waits_after_10, 200 * US);
        run(m);
        assert_false(was_computing);
        assert_int_equal(n->idle, 190 * US);
        assert_int_equal(units_left, 10 * UNITS_PER_US);
        end(m);
    }
}

static void crashes_after_100(struct fake_node *n)
{
    compute(n, 100);
    n->crashes = true;
    fiber_finish(&n->lp.fiber);
}

static void a_crash_is_reported_at_the_next_slice_boundary(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    add(m, 0, crashes_after_100);
    add(m, 1, calls_after_30_and_40);
    run(m);
    assert_log(m, "30c1 40c1 40e1 250x0");
    end(m);
}

static void computes_endlessly(struct fake_node *n)
{
    for (;;)
        compute(n, 1);
}

static void the_limit_of_time_stops_the_machine(void **state)
{
    (void)state;
    for (int interruptible = 0; interruptible < 2; interruptible++) {
        struct fake_machine *m = machine();
        m->s.max_time = 300 * US;
        add(m, 0, computes_endlessly)->interruptible = interruptible;
        add(m, 1, calls_after_30_and_40);
        add(m, 2, calls_after_500);
        run(m);
        assert_log(m, "30c1 40c1 40e1");
        assert_int_equal(m->s.stop, STOP_VIRTUAL_TIME);
        end(m);
    }
}

static void calls_after_300(struct fake_node *n)
{
    compute(n, 300), call(n);
}

static void what_happens_at_the_limit_of_time_is_committed(void **state)
{
    struct fake_machine *m = machine();
    (void)state;
    m->s.max_time = 300 * US;
    add(m, 0, calls_after_300);
    add(m, 1, calls_after_300);
    add(m, 2, calls_after_300)->interruptible = true;
    run(m);
    assert_log(m, "300c0 300e0 300c1 300e1 300c2 300e2");
    assert_int_equal(m->s.stop, STOP_NOT);
    end(m);
}

/* --- threads --- */

static uint64_t next_random(struct fake_node *n, uint64_t below)
{
    n->random = n->random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (n->random >> 33) % below;
}

static void computes_calls_and_sends(struct fake_node *n)
{
    for (int i = 0; i < 40; i++) {
        compute(n, next_random(n, 8) ? next_random(n, 300) : 1000 + next_random(n, 5000));
        call_and_send(n, next_random(n, 2) ? (uint32_t)next_random(n, NODES) : n->lp.address);
    }
}

static struct fake_machine *run_all(unsigned threads, uint64_t shuffle, vtime longest_slice)
{
    struct fake_machine *m = machine();
    m->system = 7 * US;
    m->s.longest_slice = longest_slice;
    for (uint32_t i = 0; i < NODES; i++) {
        struct fake_node *n = add(m, i, computes_calls_and_sends);
        n->interruptible = i % 2;
        n->states_lookahead = i % 4 == 1;
    }
    run_with(m, threads, shuffle);
    return m;
}

static void threads_shuffling_and_slices_change_nothing(void **state)
{
    static const vtime SLICE[] = {0, 13 * US, 400 * US};
    struct fake_machine *first = run_all(1, 0, 0);
    (void)state;
    assert_true(first->log_count > NODES * 41);
    for (unsigned threads = 1; threads <= 4; threads++)
        for (uint64_t shuffle = 0; shuffle < 3; shuffle++)
            for (int i = 0; i < 3; i++) {
                struct fake_machine *m = run_all(threads, shuffle, SLICE[i]);
                assert_int_equal(m->log_count, first->log_count);
                for (size_t e = 0; e < m->log_count; e++) {
                    assert_int_equal(m->log[e].time, first->log[e].time);
                    assert_int_equal(m->log[e].address, first->log[e].address);
                    assert_int_equal(m->log[e].what, first->log[e].what);
                }
                end(m);
            }
    end(first);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(calls_are_committed_in_the_order_of_time_then_address),
        cmocka_unit_test(calls_in_no_time_are_one_nodes_before_the_next),
        cmocka_unit_test(a_blocked_node_resumes_only_when_what_it_waits_for_is_there),
        cmocka_unit_test(a_node_that_nothing_reaches_stays_blocked),
        cmocka_unit_test(a_lazily_blocked_node_has_no_event_and_is_blocked_when_a_message_comes),
        cmocka_unit_test(a_lazily_blocked_node_resumes_at_its_commit_time_if_the_message_came_before),
        cmocka_unit_test(a_node_woken_before_its_commit_time_asks_then),
        cmocka_unit_test(a_node_notified_of_later_than_its_commit_time_resumes_then),
        cmocka_unit_test(a_moment_that_the_machine_has_passed_gets_an_event),
        cmocka_unit_test(stolen_time_puts_commit_times_off),
        cmocka_unit_test(what_is_stolen_while_a_commit_is_put_off_puts_it_off_again),
        cmocka_unit_test(a_lazily_blocked_node_is_blocked_later_by_what_is_stolen),
        cmocka_unit_test(what_a_node_waits_for_may_come_in_the_time_stolen_before_its_commit),
        cmocka_unit_test(what_is_stolen_in_its_own_call_puts_a_programs_next_call_off),
        cmocka_unit_test(a_program_paused_at_a_poll_is_gone_on_with_when_all_others_have_come_so_far),
        cmocka_unit_test(two_paused_programs_wait_for_each_other),
        cmocka_unit_test(a_paused_program_catches_up_when_a_message_comes_before),
        cmocka_unit_test(nobody_waits_for_a_paused_program_within_its_lookahead),
        cmocka_unit_test(a_deferred_call_with_an_event_is_committed_in_the_order_of_all),
        cmocka_unit_test(a_deferred_call_without_an_event_is_committed_before_anything_reaches_the_node),
        cmocka_unit_test(a_program_that_drains_goes_on_when_its_deferred_calls_are_committed),
        cmocka_unit_test(roll_back_takes_computing_back_to_the_moment),
        cmocka_unit_test(roll_back_takes_stolen_time_off_what_was_computed),
        cmocka_unit_test(roll_back_takes_back_deferred_calls_that_are_not_committed),
        cmocka_unit_test(a_blocked_node_has_idled_until_it_is_killed),
        cmocka_unit_test(a_crash_is_reported_at_the_next_slice_boundary),
        cmocka_unit_test(the_limit_of_time_stops_the_machine),
        cmocka_unit_test(what_happens_at_the_limit_of_time_is_committed),
        cmocka_unit_test(threads_shuffling_and_slices_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
