/* Deferred calls: committed in order and at their times, put off by stolen time, rolled back without a trace.
 *
 * The nodes have no program: the tests make the calls. Network, matching and accounts are the real ones. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "lp/clock.h"
#include "lp/dispatch.h"
#include "lp/engine.h"
#include "machine/assemble.h"
#include "node/system.h"
#include "os/charge.h"
#include "os/deferred.h"
#include "os/front.h"
#include "os/gate.h"
#include "os/match.h"
#include "os/observer.h"
#include "os/unexpected.h"

enum { NODES = 2, BYTES = 80, LONG_BYTES = 120, CALL = 3, SEND = 33, ARRIVE = 15 /* us */ };
#define US VT_MICROSECOND
/* At 40 MHz. */
#define UNITS_PER_US (UINT64_C(40) * NXC_UNITS_PER_CLOCK)

/* A sender's call takes 30 us for a message, which arrives 10 us after it has left, and takes the receiver's
 * processor for 5 us. */
static const struct cfg_machine CFG = {.name = "test",
                                       .clock_hz = 40000000,
                                       .memory_bytes = 1 << 20,
                                       .short_limit = 100,
                                       .short_hop_ps = 10 * US,
                                       .short_send_ps = 30 * US,
                                       .short_receive_ps = 5 * US,
                                       .forced_send_ps = 30 * US,
                                       .ask_send_ps = 30 * US,
                                       .copy_ps_per_byte = US / 10};

struct fake {
    struct cfg_machine cfg;
    struct node_system sys;
    struct node *nodes[NODES], *n; /* n: node 0, which defers */
    int64_t budget, lookahead;
    struct receive receive[DEFERRED_MOST];
    int receives;
};

static void begin(struct fake *f)
{
    *f = (struct fake){
        .cfg = CFG, .sys = {.cfg = &f->cfg, .nodes = f->nodes, .count = NODES, .most_unreceived = 1 << 20}};
    f->sys.schedule = (struct schedule){.q = evq_new(), .max_time = VT_NEVER};
    assert_true(topo_hypercube(&f->sys.topo, NODES, 1));
    f->sys.schedule.protocol = protocol_new(&f->cfg, &f->sys.topo, f->sys.schedule.q, &f->sys);
    for (uint32_t i = 0; i < NODES; i++)
        f->nodes[i] = node_new_empty(&f->sys, i);
    f->n = f->nodes[0];
    f->n->lp.state = LP_COMPUTING;
    lp_bind(&f->n->lp, &f->budget, &f->lookahead);
    clock_begin_segment(&f->n->lp);
    clock_allow(&f->n->lp, VT_NEVER);
}

static void end(struct fake *f)
{
    struct protocol *p = f->sys.schedule.protocol;
    while (evq_step(f->sys.schedule.q, &f->sys.schedule.present, &f->sys.schedule.reached))
        ;
    deferred_undo(f->n);
    for (uint32_t i = 0; i < NODES; i++) {
        match_empty(f->nodes[i], 0);
        node_delete(f->nodes[i]);
    }
    protocol_free(p);
    evq_free(f->sys.schedule.q);
    arena_free(&f->sys.made);
    arena_free(&f->sys.made_cold);
}

/* --- what node 0's program does --- */

static void compute(struct fake *f, vtime us)
{
    f->budget -= (int64_t)(us * UNITS_PER_US);
    clock_sync(&f->n->lp);
}

static void enter(struct fake *f, const char *call)
{
    f->n->call.name = call;
    f->n->call.since = clock_stop(&f->n->lp);
    deferred_begin(f->n);
}

static void leave(struct fake *f)
{
    f->n->call.name = NULL;
    f->n->deferred.open = false;
    clock_begin_segment(&f->n->lp);
    clock_allow(&f->n->lp, VT_NEVER);
}

static void send(struct fake *f, int32_t type)
{
    static const char data[BYTES];
    enter(f, "csend");
    f->n->stats.sent++, f->n->stats.sent_bytes += BYTES;
    node_spend(f->n, CALL * US);
    front_send(f->n, protocol_message(f->sys.schedule.protocol, 0, 1, type, 0, data, BYTES));
    leave(f);
}

static struct receive *post(struct fake *f, int32_t type)
{
    struct receive *r = &f->receive[f->receives++];
    *r = (struct receive){.select = {type, -1, -1}};
    enter(f, "irecv");
    node_spend(f->n, CALL * US);
    front_post(f->n, r);
    leave(f);
    return r;
}

/* A receive whose message is there. */
static void receive(struct fake *f, int32_t type)
{
    struct receive *r = &f->receive[f->receives++];
    *r = (struct receive){.select = {type, -1, -1}};
    enter(f, "crecv");
    node_spend(f->n, CALL * US);
    front_post(f->n, r);
    struct message *m = r->m;
    assert_non_null(m);
    deferred_resume_caller(f->n);
    m->receive = NULL, r->m = NULL;
    front_received(f->n, m);
    leave(f);
}

/* Asks for what has not come. */
static void ask(struct fake *f)
{
    node_enter_asking(f->n, "iprobe");
    node_answers(f->n, false);
    node_spend(f->n, CALL * US);
    leave(f);
}

/* --- what happens to it --- */

/* Node 1 sends it a message that arrives at t; or a long one, whose envelope does. */
static void bytes_at(struct fake *f, vtime t, int32_t type, size_t bytes)
{
    struct protocol *p = f->sys.schedule.protocol;
    static const char data[LONG_BYTES];
    protocol_send(p, protocol_message(p, 1, 0, type, 0, data, bytes), t - 10 * US);
}

static void message_at(struct fake *f, vtime t, int32_t type)
{
    bytes_at(f, t, type, BYTES);
}

/* The machine commits all events until t. */
static void run_until(struct fake *f, vtime t)
{
    while (evq_next(f->sys.schedule.q) <= t)
        evq_step(f->sys.schedule.q, &f->sys.schedule.present, &f->sys.schedule.reached);
}

/* The machine has stopped: calls that needed no event are committed, too. */
static void run_to_the_end(struct fake *f)
{
    run_until(f, VT_SECOND);
    deferred_commit_until(f->n, (struct instant){VT_SECOND, 0});
}

/* One that arrived before its program computed. */
static void begin_with_unexpected(struct fake *f, int32_t type)
{
    begin(f);
    message_at(f, 20 * US, type);
    run_until(f, 40 * US);
    clock_add_stolen(&f->n->lp);
}

/* An event that is earlier than all calls: somebody could interfere. */
static void nothing(void *ctx, void *arg, vtime now)
{
    (void)ctx, (void)arg, (void)now;
}

static void others_may_interfere(struct fake *f)
{
    evq_put(f->sys.schedule.q, f->sys.schedule.present.time, 1, nothing, NULL, NULL);
}

/* All that the node knows of its time, memory and messages. */
struct books {
    vtime now, tasks[NODE_TASKS], system;
    uint64_t units, sent, sent_bytes;
    size_t buffered, taken, used;
    const struct message *unexpected[2]; /* of types 1 and 2 */
};

static struct books books_of(struct fake *f)
{
    struct node *n = f->n;
    struct books b;
    memset(&b, 0, sizeof b);
    b.now = clock_sync(&n->lp), b.units = n->lp.clock.units, b.system = n->times.system;
    memcpy(b.tasks, n->times.tasks, sizeof b.tasks);
    b.sent = n->stats.sent, b.sent_bytes = n->stats.sent_bytes;
    b.buffered = n->memory.buffered, b.taken = n->memory.taken, b.used = n->memory.buffered;
    for (int i = 0; i < 2; i++)
        b.unexpected[i] = unexpected_first(n, &(struct selector){i + 1, -1, -1});
    return b;
}

static void assert_same_books(struct fake *f, struct books before)
{
    struct books now = books_of(f);
    assert_memory_equal(&now, &before, sizeof now);
}

/* When the message of a type is complete at node 1, which receives none; VT_NEVER: it has not come. */
static vtime complete_at(struct fake *f, int32_t type)
{
    const struct message *m = unexpected_first(f->nodes[1], &(struct selector){type, -1, -1});
    return m && m->whole ? m->complete : VT_NEVER;
}

/* --- commits --- */

static void deferred_calls_are_committed_in_order_and_at_their_times(void **state)
{
    struct fake f;
    (void)state;
    begin(&f);
    others_may_interfere(&f);
    compute(&f, 100), send(&f, 1); /* at 100 us */
    compute(&f, 67), send(&f, 2);  /* at 200 us */
    assert_int_equal(clock_sync(&f.n->lp), (200 + SEND) * US);
    assert_int_equal(f.n->deferred.count, 2);
    run_until(&f, 99 * US);
    assert_int_equal(f.n->deferred.count, 2);
    run_until(&f, 100 * US);
    assert_int_equal(f.n->deferred.count, 1);
    run_until(&f, VT_SECOND);
    assert_int_equal(f.n->deferred.count, 0);
    assert_int_equal(complete_at(&f, 1), (100 + SEND + ARRIVE) * US);
    assert_int_equal(complete_at(&f, 2), (200 + SEND + ARRIVE) * US);
    assert_int_equal(f.n->times.tasks[NODE_SENDING], 2 * (SEND - CALL) * US);
    end(&f);
}

/* A subscriber that counts what becomes of calls. */
struct calls_counted {
    struct observer observer; /* first */
    int deferred, committed, left;
    vtime at[2];
};

static void count_deferred(struct observer *o, struct node *n)
{
    (void)n;
    ((struct calls_counted *)o)->deferred++;
}

static void count_committed(struct observer *o, struct node *n, vtime t)
{
    struct calls_counted *c = (struct calls_counted *)o;
    (void)n;
    c->at[c->committed++ % 2] = t;
}

static void count_left(struct observer *o, struct node *n)
{
    (void)n;
    ((struct calls_counted *)o)->left++;
}

static void what_becomes_of_deferred_calls_is_announced(void **state)
{
    static const struct announcements hears = {
        .deferred = count_deferred, .committed = count_committed, .popped = count_left};
    struct calls_counted c = {.observer.hears = &hears};
    struct fake f;
    (void)state;
    begin(&f);
    observer_add(f.n, &c.observer);
    others_may_interfere(&f);
    compute(&f, 100), send(&f, 1);
    compute(&f, 67), send(&f, 2);
    assert_int_equal(c.deferred, 2);
    assert_int_equal(c.committed, 0);
    run_until(&f, 100 * US);
    assert_int_equal(c.committed, 1);
    run_until(&f, VT_SECOND);
    assert_int_equal(c.committed, 2);
    assert_int_equal(c.left, 2);
    assert_true(c.at[0] == 100 * US && c.at[1] == 200 * US);
    end(&f);
}

static void a_receive_is_posted_when_the_machine_has_come_to_its_commit_time(void **state)
{
    struct fake f;
    (void)state;
    begin(&f);
    compute(&f, 100);
    struct receive *r = post(&f, 1);
    assert_int_equal(evq_next(f.sys.schedule.q), VT_NEVER);
    deferred_commit_until(f.n, (struct instant){100 * US, 0});
    assert_null(f.n->mailbox.posted.first);
    deferred_commit_until(f.n, (struct instant){100 * US, 1});
    assert_ptr_equal(f.n->mailbox.posted.first, r);
    assert_int_equal(clock_sync(&f.n->lp), (100 + CALL) * US);
    match_withdraw(f.n, r);
    end(&f);
}

static void there_is_room_for_so_many_and_no_more(void **state)
{
    struct fake f;
    (void)state;
    begin(&f);
    for (int round = 0; round < 3; round++) {
        for (int i = 0; i < DEFERRED_MOST; i++) {
            assert_true(deferred_has_room(f.n));
            compute(&f, 1), send(&f, i);
        }
        assert_false(deferred_has_room(f.n));
        run_to_the_end(&f);
    }
    end(&f);
}

/* --- receives and what has come --- */

static void a_receive_that_selects_an_unexpected_message_has_it_at_once(void **state)
{
    struct fake f;
    (void)state;
    begin_with_unexpected(&f, 1);
    compute(&f, 100);
    struct receive *r = post(&f, 1), *other = post(&f, 2);
    assert_non_null(r->m);
    assert_null(other->m);
    assert_null(unexpected_first(f.n, &r->select));
    assert_int_equal(f.n->deferred.count, 2);
    deferred_roll_back(f.n);
    end(&f);
}

static void a_receive_has_a_message_that_comes_before_its_commit_time_at_once(void **state)
{
    struct fake f;
    (void)state;
    begin(&f);
    message_at(&f, 50 * US, 1);
    compute(&f, 100);
    struct receive *r = post(&f, 1);
    run_until(&f, 49 * US);
    assert_null(r->m);
    run_until(&f, 50 * US);
    assert_non_null(r->m);
    assert_int_equal(f.n->deferred.count, 1);
    assert_int_equal(evq_next(f.sys.schedule.q), VT_NEVER);
    deferred_roll_back(f.n);
    assert_non_null(unexpected_first(f.n, &(struct selector){1, -1, -1}));
    end(&f);
}

static void a_receive_selects_a_long_message_at_its_commit_time(void **state)
{
    struct fake f;
    (void)state;
    begin(&f);
    f.cfg.long_hop_ps = 10 * US;
    bytes_at(&f, 95 * US, 1, LONG_BYTES);
    compute(&f, 100);
    struct receive *r = post(&f, 1);
    run_until(&f, 99 * US);
    assert_null(r->m);
    run_until(&f, 100 * US);
    assert_non_null(r->m);
    assert_int_equal(f.n->deferred.count, 0);
    run_to_the_end(&f);
    match_withdraw(f.n, r);
    end(&f);
}

static void a_later_receive_leaves_a_message_to_an_earlier_one(void **state)
{
    struct fake f;
    (void)state;
    begin(&f);
    f.cfg.short_receive_ps = 0;
    message_at(&f, 50 * US, 1);
    compute(&f, 100);
    struct receive *first = post(&f, 1);
    run_until(&f, 60 * US);
    struct receive *second = post(&f, -1);
    assert_non_null(first->m);
    assert_null(second->m);
    run_to_the_end(&f);
    assert_null(second->m);
    match_withdraw(f.n, first);
    match_withdraw(f.n, second);
    end(&f);
}

static void a_buffer_is_free_when_the_receive_is_committed(void **state)
{
    struct fake f;
    (void)state;
    begin_with_unexpected(&f, 1);
    compute(&f, 100);
    receive(&f, 1);
    assert_int_equal(f.n->memory.buffered, BYTES);
    assert_int_equal(f.n->memory.taken, BYTES);
    assert_int_equal(f.n->times.tasks[NODE_COPYING], BYTES * US / 10);
    deferred_commit_until(f.n, (struct instant){VT_SECOND, 0});
    assert_int_equal(f.n->memory.buffered, 0);
    assert_int_equal(f.n->memory.taken, 0);
    end(&f);
}

/* --- sends --- */

static void a_message_goes_at_once_if_nothing_can_reach_the_node_before(void **state)
{
    (void)state;
    for (int interfere = 0; interfere < 2; interfere++) {
        struct fake f;
        begin(&f);
        if (interfere)
            others_may_interfere(&f);
        compute(&f, 100), send(&f, 1);
        assert_int_equal(protocol_under_way(f.sys.schedule.protocol), !interfere);
        assert_int_equal(f.n->deferred.count, 1);
        run_to_the_end(&f);
        assert_int_equal(complete_at(&f, 1), (100 + SEND + ARRIVE) * US);
        end(&f);
    }
}

static void a_message_does_not_overtake_one_that_waits_for_its_event(void **state)
{
    struct fake f;
    (void)state;
    begin(&f);
    others_may_interfere(&f);
    compute(&f, 100), send(&f, 1);
    evq_step(f.sys.schedule.q, &f.sys.schedule.present,
             &f.sys.schedule.reached); /* now nothing can reach the node */
    compute(&f, 67), send(&f, 2);
    assert_int_equal(protocol_under_way(f.sys.schedule.protocol), 0);
    run_until(&f, 100 * US);
    assert_int_equal(protocol_under_way(f.sys.schedule.protocol), 1);
    end(&f);
}

/* --- stolen time --- */

static void stolen_time_shifts_all_deferred_calls(void **state)
{
    struct fake f;
    (void)state;
    begin(&f);
    message_at(&f, 50 * US, 7);
    message_at(&f, 150 * US, 8);
    compute(&f, 100), send(&f, 1); /* at 105 us */
    compute(&f, 67), send(&f, 2);  /* at 210 us */
    compute(&f, 67), post(&f, 3);  /* at 310 us */
    run_until(&f, 160 * US);
    assert_int_equal(f.n->deferred.count, 2);
    assert_int_equal(deferred_last(f.n), 310 * US);
    run_until(&f, 309 * US);
    assert_int_equal(f.n->deferred.count, 1);
    run_to_the_end(&f);
    assert_int_equal(complete_at(&f, 1), (105 + SEND + ARRIVE) * US);
    assert_int_equal(complete_at(&f, 2), (210 + SEND + ARRIVE) * US);
    assert_int_equal(f.n->deferred.count, 0);
    assert_int_equal(clock_sync(&f.n->lp), (310 + CALL) * US);
    match_withdraw(f.n, &f.receive[0]);
    end(&f);
}

/* --- roll back --- */

static void sends_and_receives(struct fake *f)
{
    post(f, 1);
    compute(f, 10), receive(f, 2);
    compute(f, 10), send(f, 5);
    compute(f, 10), post(f, 3);
    compute(f, 10), send(f, 6);
}

static void what_is_rolled_back_has_left_no_trace(void **state)
{
    (void)state;
    for (int interfere = 0; interfere < 2; interfere++) {
        struct fake f;
        begin_with_unexpected(&f, 1);
        message_at(&f, 60 * US, 2);
        run_until(&f, 80 * US);
        clock_add_stolen(&f.n->lp);
        if (interfere)
            others_may_interfere(&f);
        compute(&f, 100);
        struct books before = books_of(&f);
        sends_and_receives(&f);
        assert_int_equal(f.n->memory.taken, BYTES);
        assert_true(clock_sync(&f.n->lp) > before.now);
        deferred_roll_back(f.n);
        assert_same_books(&f, before);
        assert_int_equal(f.n->deferred.count, 0);
        run_until(&f, VT_SECOND);
        assert_int_equal(complete_at(&f, 5), VT_NEVER);
        assert_int_equal(complete_at(&f, 6), VT_NEVER);
        end(&f);
    }
}

static void what_is_committed_is_not_rolled_back(void **state)
{
    struct fake f;
    (void)state;
    begin(&f);
    message_at(&f, 50 * US, 7);
    compute(&f, 100), send(&f, 1);
    compute(&f, 67);
    run_until(&f, 105 * US);
    struct books before = books_of(&f);
    send(&f, 2);
    compute(&f, 50);
    deferred_roll_back(f.n);
    assert_same_books(&f, before);
    run_until(&f, VT_SECOND);
    assert_int_equal(complete_at(&f, 1), (105 + SEND + ARRIVE) * US);
    assert_int_equal(complete_at(&f, 2), VT_NEVER);
    end(&f);
}

static void a_call_that_was_put_off_is_rolled_back_to_its_later_time(void **state)
{
    struct fake f;
    (void)state;
    begin(&f);
    message_at(&f, 50 * US, 7);
    compute(&f, 100), send(&f, 1);
    compute(&f, 67), send(&f, 2);
    run_until(&f, 105 * US);
    deferred_roll_back(f.n);
    assert_int_equal(clock_sync(&f.n->lp), 205 * US);
    assert_int_equal(f.n->stats.sent, 1);
    end(&f);
}

/* Events of others at 0 reach it SEND us later at the earliest. */
static void a_call_that_asks_is_deferred_while_nothing_can_reach_the_node(void **state)
{
    (void)state;
    struct fake f;
    begin(&f);
    others_may_interfere(&f);
    compute(&f, 5);
    struct books before = books_of(&f);
    ask(&f);
    compute(&f, 4);
    ask(&f);
    assert_int_equal(f.n->deferred.count, 2);
    assert_true(deferred_only_ask(f.n));
    assert_int_equal(node_now(f.n), (5 + CALL + 4 + CALL) * US);
    deferred_roll_back(f.n);
    assert_same_books(&f, before);
    compute(&f, 1);
    ask(&f);
    run_to_the_end(&f);
    assert_int_equal(f.n->deferred.count, 0);
    assert_int_equal(f.n->times.system, CALL * US);
    end(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(deferred_calls_are_committed_in_order_and_at_their_times),
        cmocka_unit_test(what_becomes_of_deferred_calls_is_announced),
        cmocka_unit_test(a_receive_is_posted_when_the_machine_has_come_to_its_commit_time),
        cmocka_unit_test(there_is_room_for_so_many_and_no_more),
        cmocka_unit_test(a_receive_that_selects_an_unexpected_message_has_it_at_once),
        cmocka_unit_test(a_receive_has_a_message_that_comes_before_its_commit_time_at_once),
        cmocka_unit_test(a_receive_selects_a_long_message_at_its_commit_time),
        cmocka_unit_test(a_later_receive_leaves_a_message_to_an_earlier_one),
        cmocka_unit_test(a_buffer_is_free_when_the_receive_is_committed),
        cmocka_unit_test(a_message_goes_at_once_if_nothing_can_reach_the_node_before),
        cmocka_unit_test(a_message_does_not_overtake_one_that_waits_for_its_event),
        cmocka_unit_test(a_call_that_asks_is_deferred_while_nothing_can_reach_the_node),
        cmocka_unit_test(stolen_time_shifts_all_deferred_calls),
        cmocka_unit_test(what_is_rolled_back_has_left_no_trace),
        cmocka_unit_test(what_is_committed_is_not_rolled_back),
        cmocka_unit_test(a_call_that_was_put_off_is_rolled_back_to_its_later_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
