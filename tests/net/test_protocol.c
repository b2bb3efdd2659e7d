/* The protocol: eager or rendezvous, the iPSC/860's published times, order of envelopes, waiting for room. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "net/endpoint.h"
#include "tests/child.h"

enum { NODES = 8, HOST = NODES, US = 1000000 };

/* Nodes that do nothing but note what happens. */
struct fake {
    struct evq *q;
    struct protocol *protocol;
    vtime free_at[NODES + 1];
    bool room;
    struct message *seen[16], *kept;
    int seen_count, arrived_count;
    vtime complete[16];
    vtime moved[2]; /* by programmed I/O: sending, receiving */
};

vtime endpoint_work(void *ctx, uint32_t node, enum protocol_task task, vtime at, vtime t)
{
    struct fake *f = ctx;
    (void)task;
    return f->free_at[node] = vt_max(f->free_at[node], at) + t;
}

void endpoint_pio(void *ctx, uint32_t node, enum protocol_task task, vtime at, vtime t)
{
    struct fake *f = ctx;
    (void)node, (void)at;
    f->moved[task] += t;
}

bool endpoint_envelope(void *ctx, struct message *m, vtime now)
{
    struct fake *f = ctx;
    (void)now;
    f->seen[f->seen_count++] = m;
    return f->room;
}

void endpoint_sent(void *ctx, struct message *m, vtime now)
{
    (void)ctx, (void)m, (void)now;
}

void endpoint_arrived(void *ctx, struct message *m, vtime now)
{
    struct fake *f = ctx;
    (void)now;
    f->complete[f->arrived_count++] = m->complete;
}

/* The iPSC/860's published sums, divided in some way. */
static const struct cfg_machine IPSC = {.short_hop_ps = 10 * US,
                                        .long_hop_ps = 10 * US,
                                        .short_ps_per_byte = 425000,
                                        .long_ps_per_byte = 390000,
                                        .short_limit = 100,
                                        .short_send_ps = 35 * US,
                                        .short_receive_ps = 30 * US,
                                        .forced_send_ps = 45 * US,
                                        .forced_receive_ps = 50 * US,
                                        .ask_send_ps = 40 * US,
                                        .ask_receive_ps = 37 * US,
                                        .grant_receive_ps = 35 * US,
                                        .long_receive_ps = 35 * US};

static void begin(struct fake *f, bool room)
{
    struct topo topo;
    *f = (struct fake){.q = evq_new(), .room = room};
    assert_true(topo_hypercube(&topo, NODES, 3));
    f->protocol = protocol_new(&IPSC, &topo, f->q, f);
}

static void run(struct fake *f)
{
    while (evq_step(f->q, &(struct instant){0}, &(struct instant){0}))
        ;
}

static void end(struct fake *f)
{
    for (int i = 0; i < f->seen_count; i++)
        protocol_message_free(f->seen[i]);
    protocol_free(f->protocol);
    evq_free(f->q);
}

/* The same with a host, whose link takes 500 us a trip and 1 us a byte. */
static void begin_with_host(struct fake *f)
{
    static struct cfg_machine cfg;
    struct topo topo;
    cfg = IPSC;
    cfg.host.link_ps = 500 * US, cfg.host.link_ps_per_byte = US;
    *f = (struct fake){.q = evq_new(), .room = true};
    assert_true(topo_hypercube(&topo, NODES, 3));
    topo_add_host(&topo);
    assert_int_equal(topo_host(&topo), HOST);
    f->protocol = protocol_new(&cfg, &topo, f->q, f);
}

/* Sends from node 0 as a call at time 0 would; returns the message. */
static struct message *send(struct fake *f, uint32_t to, int32_t type, size_t bytes, vtime at)
{
    static char data[10000];
    struct message *m = protocol_message(f->protocol, 0, to, type, 0, data, bytes);
    protocol_send(f->protocol, m, at + protocol_send_time(f->protocol, type, bytes));
    return m;
}

static vtime one_way(uint32_t to, int32_t type, size_t bytes)
{
    struct fake f;
    begin(&f, true);
    send(&f, to, type, bytes, 0);
    run(&f);
    assert_int_equal(f.arrived_count, 1);
    vtime t = f.complete[0];
    end(&f);
    return t;
}

static void short_messages_take_65_us_and_0_425_a_byte_and_10_a_hop(void **state)
{
    (void)state;
    assert_int_equal(one_way(1, 5, 0), 75 * US);
    assert_int_equal(one_way(7, 5, 0), 95 * US);
    assert_int_equal(one_way(1, 5, 100), 75 * US + 42500000);
}

static void long_messages_take_147_us_and_0_39_a_byte_and_30_a_hop(void **state)
{
    (void)state;
    assert_int_equal(one_way(1, 5, 101), (147 + 30) * US + 101 * 390000);
    assert_int_equal(one_way(7, 5, 10000), (147 + 90) * US + 10000 * 390000ull);
}

static void forced_messages_need_no_request_to_send(void **state)
{
    (void)state;
    assert_int_equal(one_way(1, PROTOCOL_FORCED | 5, 1000), (45 + 10 + 50) * US + 1000 * 390000);
}

static void a_long_message_without_room_waits_for_a_clear_to_send(void **state)
{
    struct fake f;
    (void)state;
    begin(&f, false);
    struct message *m = send(&f, 1, 5, 1000, 0);
    run(&f);
    assert_int_equal(f.seen_count, 1);
    assert_int_equal(f.arrived_count, 0);
    assert_int_equal(protocol_under_way(f.protocol), 1);
    protocol_clear_to_send(f.protocol, m, 5000 * (vtime)US);
    run(&f);
    assert_int_equal(f.complete[0], (5000 + 10 + 35 + 10 + 35) * (vtime)US + 1000 * 390000);
    end(&f);
}

static void a_forced_message_without_a_receive_is_dropped(void **state)
{
    struct fake f;
    (void)state;
    begin(&f, false);
    send(&f, 1, PROTOCOL_FORCED | 5, 1000, 0);
    run(&f);
    assert_int_equal(f.seen_count, 1);
    assert_int_equal(f.arrived_count, 0);
    assert_int_equal(protocol_under_way(f.protocol), 0);
    f.seen_count = 0; /* freed by the protocol */
    end(&f);
}

static void envelopes_between_two_nodes_are_seen_in_the_order_sent(void **state)
{
    struct fake f;
    struct message *sent_in_order[3];
    (void)state;
    begin(&f, true);
    sent_in_order[0] = send(&f, 1, 5, 100, 0);  /* 42.5 us on the wire */
    sent_in_order[1] = send(&f, 1, 5, 100, 1);  /* waits for it */
    sent_in_order[2] = send(&f, 1, 5, 5000, 2); /* its request to send uses no channel, and comes first */
    run(&f);
    assert_int_equal(f.seen_count, 3);
    for (int i = 0; i < 3; i++)
        assert_ptr_equal(f.seen[i], sent_in_order[i]);
    end(&f);
}

static vtime to_all(uint32_t root, int32_t type, size_t bytes)
{
    struct fake f;
    vtime last = 0, at = 0;
    bool reached[NODES] = {false};
    begin(&f, true);
    for (struct message *m = protocol_to_all(f.protocol, root, type, 0, NULL, bytes), *next; m; m = next) {
        next = m->next;
        at += protocol_send_time(f.protocol, type, bytes);
        protocol_send(f.protocol, m, at);
    }
    run(&f);
    assert_int_equal(f.arrived_count, NODES - 1);
    assert_int_equal(protocol_under_way(f.protocol), 0);
    for (int i = 0; i < f.seen_count; i++) {
        assert_int_equal(f.seen[i]->source, root);
        assert_int_not_equal(f.seen[i]->to, root);
        assert_false(reached[f.seen[i]->to]);
        reached[f.seen[i]->to] = true;
        last = vt_max(last, f.complete[i]);
    }
    end(&f);
    return last;
}

/* Each of the three steps goes to a neighbour: 65 us and 10 for the hop. */
static void a_message_to_all_takes_as_many_steps_as_the_cube_has_dimensions(void **state)
{
    (void)state;
    for (uint32_t root = 0; root < NODES; root++) {
        assert_int_equal(to_all(root, 5, 0), 3 * 75 * US);
        assert_int_equal(to_all(root, PROTOCOL_FORCED | 5, 0), 3 * 75 * US);
    }
    assert_in_range(to_all(5, 5, 1000), 3 * (177 + 390) * (vtime)US, 3 * (177 + 390 + 80) * (vtime)US);
}

static void a_later_message_does_not_overtake_one_to_all(void **state)
{
    struct fake f;
    (void)state;
    begin(&f, true);
    for (struct message *m = protocol_to_all(f.protocol, 0, 5, 0, NULL, 100), *next; m; m = next) {
        next = m->next;
        protocol_send(f.protocol, m, 0);
    }
    struct message *direct = send(&f, 7, 5, 0, 1); /* node 7 gets the one before it by way of 4 and 6 */
    run(&f);
    assert_ptr_equal(f.seen[NODES - 1], direct);
    end(&f);
}

static void nothing_reaches_a_node_before_its_horizon(void **state)
{
    struct fake f;
    (void)state;
    begin(&f, true);
    send(&f, 1, 5, 5000, 0);
    send(&f, 1, 6, 50, 200 * (vtime)US);
    int seen = 0;
    vtime horizon = 0;
    while (evq_next(f.q) != VT_NEVER) {
        vtime now = evq_next(f.q);
        horizon = protocol_horizon(f.protocol, 1, now);
        assert_true(horizon >= now);
        vtime busy = f.free_at[1];
        assert_true(evq_step(f.q, &(struct instant){0}, &(struct instant){0}));
        if (f.free_at[1] != busy || f.seen_count != seen)
            assert_true(now >= horizon); /* something reached it: not before the horizon seen just before */
        seen = f.seen_count;
    }
    assert_int_equal(f.arrived_count, 2);
    assert_int_equal(protocol_horizon(f.protocol, 1, VT_NEVER), VT_NEVER);
    end(&f);
}

/* Two nodes send each other 1,000 bytes at once, on a machine whose processors move so many messages at once.
 * When does the last come? */
static vtime exchange(uint64_t moves_at_once)
{
    struct fake f = {.q = evq_new(), .room = true};
    struct cfg_machine cfg = IPSC;
    struct topo topo;
    static char data[1000];
    cfg.moves_at_once = moves_at_once;
    assert_true(topo_hypercube(&topo, NODES, 3));
    f.protocol = protocol_new(&cfg, &topo, f.q, &f);
    for (uint32_t i = 0; i < 2; i++)
        protocol_send(f.protocol, protocol_message(f.protocol, i, 1 - i, 5, 0, data, 1000), 0);
    run(&f);
    assert_int_equal(f.arrived_count, 2);
    vtime last = vt_max(f.complete[0], f.complete[1]);
    end(&f);
    return last;
}

static void a_processor_that_moves_one_message_at_once_takes_the_directions_in_turn(void **state)
{
    (void)state;
    vtime data = 10 * US + 1000 * 390000ull; /* of a message on its way */
    assert_int_equal(exchange(0), exchange(2));
    assert_int_equal(exchange(1), exchange(0) + data);
}

/* Also where the network takes no time for them. */
static void both_processors_move_the_bytes_of_a_long_message(void **state)
{
    (void)state;
    for (uint64_t network = 0; network < 2; network++) {
        struct cfg_machine cfg = IPSC;
        struct topo topo;
        struct fake f = {.q = evq_new(), .room = true};
        cfg.long_ps_per_byte = network, cfg.send_ps_per_byte = 7, cfg.receive_ps_per_byte = 9;
        assert_true(topo_hypercube(&topo, NODES, 3));
        f.protocol = protocol_new(&cfg, &topo, f.q, &f);
        send(&f, 1, 5, 1000, 0);
        run(&f);
        assert_int_equal(f.moved[PROTOCOL_SEND], 7000);
        assert_int_equal(f.moved[PROTOCOL_RECEIVE], 9000);
        end(&f);
    }
}

static vtime from_to_with_host(uint32_t from, uint32_t to, size_t bytes)
{
    static char data[10000];
    struct fake f;
    begin_with_host(&f);
    protocol_send(f.protocol, protocol_message(f.protocol, from, to, 5, 0, data, bytes),
                  protocol_send_time(f.protocol, 5, bytes));
    run(&f);
    assert_int_equal(f.arrived_count, 1);
    vtime t = f.complete[0];
    end(&f);
    return t;
}

static void a_trip_to_or_from_the_host_crosses_its_link_and_then_the_cube_from_node_0(void **state)
{
    (void)state;
    assert_int_equal(from_to_with_host(HOST, 0, 0), (65 + 500 + 10) * US);
    assert_int_equal(from_to_with_host(HOST, 5, 100), (65 + 500 + 30 + 100) * US);
    assert_int_equal(from_to_with_host(6, HOST, 100), (65 + 500 + 30 + 100) * US);
    assert_int_equal(from_to_with_host(0, HOST, 10000), (147 + 3 * 510 + 10000) * (vtime)US);
    assert_int_equal(from_to_with_host(1, 3, 100), 75 * US + 42500000); /* not those between nodes */
}

static void what_the_host_sends_to_all_goes_to_node_0_and_on_from_there(void **state)
{
    struct fake f;
    bool got[NODES] = {false};
    (void)state;
    begin_with_host(&f);
    struct message *m = protocol_to_all(f.protocol, HOST, 5, 0, "x", 1);
    assert_null(m->next);
    protocol_send(f.protocol, m, 0);
    run(&f);
    assert_int_equal(f.arrived_count, NODES);
    for (int i = 0; i < NODES; i++) {
        assert_int_equal(f.seen[i]->source, HOST);
        assert_false(got[f.seen[i]->to]);
        got[f.seen[i]->to] = true;
    }
    end(&f);
}

/* The later one's request to send uses no channel, and comes to node 4 before the earlier one has crossed the
 * link. */
static void a_later_message_of_the_host_does_not_overtake_its_message_to_all(void **state)
{
    struct fake f;
    (void)state;
    begin_with_host(&f);
    protocol_send(f.protocol, protocol_to_all(f.protocol, HOST, 5, 0, NULL, 100), 0);
    struct message *direct = protocol_message(f.protocol, HOST, 4, 5, 0, NULL, 1000);
    protocol_send(f.protocol, direct, 1);
    run(&f);
    assert_int_equal(f.seen_count, NODES + 1);
    int to_4 = 0;
    for (int i = 0; i < f.seen_count; i++)
        if (f.seen[i]->to == 4 && ++to_4 == 1)
            assert_ptr_not_equal(f.seen[i], direct);
    assert_int_equal(to_4, 2);
    end(&f);
}

static void to_all_is_to_the_nodes_of_the_cube_that_there_is(void **state)
{
    struct fake f;
    (void)state;
    begin_with_host(&f);
    protocol_set_nodes(f.protocol, 4);
    for (struct message *m = protocol_to_all(f.protocol, 3, 5, 0, "x", 1), *next; m; m = next) {
        next = m->next;
        protocol_send(f.protocol, m, 0);
    }
    run(&f);
    assert_int_equal(f.arrived_count, 3); /* not the host, not nodes 4 to 7 */
    end(&f);
}

static void messages_under_way_are_found_from_both_ends(void **state)
{
    struct fake f;
    (void)state;
    begin_with_host(&f);
    struct message *m = protocol_message(f.protocol, HOST, 1, 5, 0, "x", 1);
    assert_null(protocol_to(f.protocol, 1));
    m->followed = true;
    protocol_send(f.protocol, m, 0);
    assert_ptr_equal(protocol_to(f.protocol, 1), m);
    assert_ptr_equal(protocol_from(f.protocol, HOST), m);
    run(&f);
    assert_null(protocol_to(f.protocol, 1));
    assert_null(protocol_from(f.protocol, HOST));
    end(&f);
}

static void free_twice(void *arg)
{
    struct message *m = arg;
    protocol_message_free(m);
    protocol_message_free(m);
}

static void clear_twice(void *arg)
{
    struct message *m = arg;
    protocol_clear_to_send(m->protocol, m, US);
    protocol_clear_to_send(m->protocol, m, US);
}

static void a_message_is_cleared_once_and_freed_once(void **state)
{
    struct fake f;
    (void)state;
    begin(&f, false);
    struct message *m = send(&f, 1, 5, 1000, 0);
    run(&f);
    assert_int_not_equal(child_status(clear_twice, m), 0);
    assert_int_not_equal(child_status(free_twice, m), 0);
    end(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(short_messages_take_65_us_and_0_425_a_byte_and_10_a_hop),
        cmocka_unit_test(long_messages_take_147_us_and_0_39_a_byte_and_30_a_hop),
        cmocka_unit_test(forced_messages_need_no_request_to_send),
        cmocka_unit_test(a_long_message_without_room_waits_for_a_clear_to_send),
        cmocka_unit_test(a_forced_message_without_a_receive_is_dropped),
        cmocka_unit_test(envelopes_between_two_nodes_are_seen_in_the_order_sent),
        cmocka_unit_test(a_message_to_all_takes_as_many_steps_as_the_cube_has_dimensions),
        cmocka_unit_test(a_later_message_does_not_overtake_one_to_all),
        cmocka_unit_test(nothing_reaches_a_node_before_its_horizon),
        cmocka_unit_test(a_processor_that_moves_one_message_at_once_takes_the_directions_in_turn),
        cmocka_unit_test(both_processors_move_the_bytes_of_a_long_message),
        cmocka_unit_test(a_trip_to_or_from_the_host_crosses_its_link_and_then_the_cube_from_node_0),
        cmocka_unit_test(what_the_host_sends_to_all_goes_to_node_0_and_on_from_there),
        cmocka_unit_test(a_later_message_of_the_host_does_not_overtake_its_message_to_all),
        cmocka_unit_test(to_all_is_to_the_nodes_of_the_cube_that_there_is),
        cmocka_unit_test(messages_under_way_are_found_from_both_ends),
        cmocka_unit_test(a_message_is_cleared_once_and_freed_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
