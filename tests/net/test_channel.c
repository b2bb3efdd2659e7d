/* Contention: paths that share a channel wait for each other, paths that share only a node do not. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "net/channel.h"

struct trip {
    struct channel_transit transit;
    vtime started, done;
};

static void on_started(void *ctx, struct channel_transit *t, vtime now)
{
    (void)ctx;
    ((struct trip *)t)->started = now;
}

static void on_done(void *ctx, struct channel_transit *t, vtime now)
{
    (void)ctx;
    ((struct trip *)t)->done = now;
}

static const struct channel_calls calls = {NULL, on_started, on_done, NULL, NULL};

/* Sends trips of 100 each at time 0, in order, over a cube of 8 nodes, and lets them finish. */
static void send(struct trip *trips, int count)
{
    struct topo topo;
    struct evq *q = evq_new();
    assert_true(topo_hypercube(&topo, 8, 3));
    struct channels *w = channel_new(&topo, q, &calls);
    for (int i = 0; i < count; i++) {
        trips[i].transit.duration = 100;
        channel_send(w, &trips[i].transit, 0);
    }
    while (evq_step(q, &(struct instant){0}, &(struct instant){0}))
        ;
    channel_free(w);
    evq_free(q);
}

static void a_shared_channel_serves_one_at_a_time(void **state)
{
    struct trip t[] = {{.transit = {.from = 0, .to = 3}},
                       {.transit = {.from = 1, .to = 3}}}; /* 0 1 3 and 1 3 */
    (void)state;
    send(t, 2);
    assert_int_equal(t[0].done, 100);
    assert_int_equal(t[1].started, 100);
    assert_int_equal(t[1].done, 200);
}

static void a_fast_channel_serves_more_than_one_slow_node(void **state)
{
    struct trip t[] = {{.transit = {.from = 0, .to = 3, .holds = 30}},
                       {.transit = {.from = 1, .to = 7, .holds = 30}},  /* shares 1 3 with the first */
                       {.transit = {.from = 2, .to = 3, .holds = 30}}}; /* and its port at node 3 */
    (void)state;
    send(t, 3);
    assert_int_equal(t[0].done, 100);
    assert_int_equal(t[1].done, 130);
    assert_int_equal(t[2].done, 200);
}

static void a_shared_node_costs_nothing(void **state)
{
    struct trip t[] = {{.transit = {.from = 0, .to = 3}},
                       {.transit = {.from = 1, .to = 5}}}; /* 0 1 3 and 1 5 meet in node 1 only */
    (void)state;
    send(t, 2);
    assert_int_equal(t[0].done, 100);
    assert_int_equal(t[1].done, 100);
}

static void both_directions_go_at_once(void **state)
{
    struct trip t[] = {{.transit = {.from = 0, .to = 1}}, {.transit = {.from = 1, .to = 0}}};
    (void)state;
    send(t, 2);
    assert_int_equal(t[0].done, 100);
    assert_int_equal(t[1].done, 100);
}

static void a_node_receives_one_message_at_a_time(void **state)
{
    struct trip t[] = {{.transit = {.from = 1, .to = 0}},
                       {.transit = {.from = 2, .to = 0}},
                       {.transit = {.from = 4, .to = 0}}};
    (void)state;
    send(t, 3);
    for (int i = 0; i < 3; i++)
        assert_int_equal(t[i].done, 100 * (i + 1));
}

static void a_blocked_message_holds_what_it_has(void **state)
{
    struct trip t[] = {
        {.transit = {.from = 1, .to = 3}}, /* channel 1>3 */
        {.transit = {.from = 0, .to = 3}}, /* takes 0>1, waits for 1>3 */
        {.transit = {.from = 0,
                     .to = 1}}, /* waits behind it for the port of 0, though 0>1 leads nowhere busy */
        {.transit = {.from = 2, .to = 6}}}; /* meets nobody */
    (void)state;
    send(t, 4);
    assert_int_equal(t[0].done, 100);
    assert_int_equal(t[1].done, 200);
    assert_int_equal(t[2].done, 300);
    assert_int_equal(t[3].done, 100);
}

static void a_wait_without_an_end_counts_until_the_latest_event(void **state)
{
    struct trip t[] = {{.transit = {.from = 1, .to = 3}}, {.transit = {.from = 0, .to = 3}}};
    struct evq *q = evq_new();
    struct topo topo;
    (void)state;
    assert_true(topo_hypercube(&topo, 8, 3));
    struct channels *w = channel_new(&topo, q, &calls);
    for (int i = 0; i < 2; i++) {
        t[i].transit.duration = 100;
        channel_send(w, &t[i].transit, (vtime)(50 + i));
    }
    assert_int_equal(channel_waits(w), 1);
    assert_int_equal(channel_waited(w), 0);
    channel_free(w);
    evq_free(q);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_shared_channel_serves_one_at_a_time),
        cmocka_unit_test(a_fast_channel_serves_more_than_one_slow_node),
        cmocka_unit_test(a_shared_node_costs_nothing),
        cmocka_unit_test(both_directions_go_at_once),
        cmocka_unit_test(a_node_receives_one_message_at_a_time),
        cmocka_unit_test(a_blocked_message_holds_what_it_has),
        cmocka_unit_test(a_wait_without_an_end_counts_until_the_latest_event),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
