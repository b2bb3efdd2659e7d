/* test_waitfor.c - the analysis of the wait-for graph (nx_api/waitfor): causes and reports of small machines;
 * and random graphs, whose cycles and knots are found by the plainest means, too. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <cmocka.h>
#include <jansson.h>
#include "files/virtual_time.h"
#include "nx_api/waitfor/waitfor.h"
#include "nx_api/waitfor/waitfor_parts.h"

/* --- machines made by hand --- */

static struct waitfor_node *receives(struct waitfor *w, uint32_t i, long typesel, long node)
{
    struct waitfor_node *n = &w->nodes[i];
    n->state = WAITFOR_WAITS;
    n->call = node == WAITFOR_ANY ? "crecv" : "crecvx";
    n->has_type = true, n->type = typesel;
    n->what = WAITFOR_MESSAGE;
    n->select = (struct waitfor_select){typesel, node, WAITFOR_ANY};
    return n;
}

static struct waitfor_node *ends(struct waitfor *w, uint32_t i)
{
    w->nodes[i].state = WAITFOR_ENDED;
    w->nodes[i].since_ps = 2000000;
    return &w->nodes[i];
}

static const struct waitfor_message FROM_2 = {
    .type = 7, .from = 2, .bytes = 8, .sent_ps = WAITFOR_NEVER, .came_ps = 1000};

static char *text_of(struct waitfor *w)
{
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    waitfor_analyse(w);
    waitfor_write_text(w, f);
    fclose(f);
    return text;
}

static void expect_text(struct waitfor *w, const char *expected)
{
    char *text = text_of(w);
    assert_string_equal(text, expected);
    free(text);
    waitfor_free(w);
}

static void expect_cause(struct waitfor *w, uint32_t node, const char *cause)
{
    waitfor_analyse(w);
    assert_string_equal(waitfor_cause_name(w->nodes[node].cause), cause);
    waitfor_free(w);
}

enum { GSYNC = 1000000000, GDSUM = GSYNC + 64 };

/* --- the graph --- */

static void three_in_a_cycle(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(4);
    for (uint32_t i = 0; i < 3; i++)
        receives(w, i, 7, (i + 2) % 3)->line = "ring.c:17";
    receives(w, 3, 7, 1)->line = "ring.c:17";
    expect_text(
        w, "  cycle: node 0 -> node 2 -> node 1 -> node 0\n"
           "  nodes 0-2: crecvx(7) since 0 s (ring.c:17)\n"
           "    cycle: for example node 0: It waits for type 7 from node 2, which waits, too.\n"
           "    One of the cycle has to send before it receives, or to post its receive (irecv) and go on.\n"
           "  node 3: crecvx(7) since 0 s (ring.c:17)\n"
           "    behind others: It waits for type 7 from node 1, which waits, too.");
}

static void a_node_that_waits_for_itself(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    receives(w, 1, 7, 1);
    waitfor_analyse(w);
    assert_int_equal(w->cycle_count, 1);
    assert_int_equal(w->cycle[0], 1);
    waitfor_free(w);
}

static void the_shortest_of_two_cycles(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(6);
    for (uint32_t i = 0; i < 4; i++)
        receives(w, i, 7, (i + 1) % 4);
    receives(w, 4, 7, 5), receives(w, 5, 7, 4);
    expect_text(
        w, "  cycle: node 4 -> node 5 -> node 4, one of several\n"
           "  nodes 0-5: crecvx(7) since 0 s\n"
           "    cycle: for example node 0: It waits for type 7 from node 1, which waits, too.\n"
           "    One of the cycle has to send before it receives, or to post its receive (irecv) and go on.");
}

static void two_operations_in_different_orders(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(4);
    receives(w, 0, GSYNC, WAITFOR_ANY), receives(w, 1, GSYNC + 1, WAITFOR_ANY);
    receives(w, 2, GDSUM, WAITFOR_ANY), receives(w, 3, GDSUM + 62, WAITFOR_ANY);
    expect_text(w, "  cycle: node 0 -> node 2 -> node 0\n"
                   "  node 0: gsync since 0 s\n"
                   "    cycle: gsync waits for nodes 2, 3 to come to it.\n"
                   "    All nodes have to call the global operations in the same order.\n"
                   "  node 1: gsync since 0 s\n"
                   "    behind others: gsync waits for nodes 2, 3 to come to it.\n"
                   "  node 2: gdsum since 0 s\n"
                   "    cycle: gdsum waits for nodes 0, 1 to come to it.\n"
                   "  node 3: gdsum since 0 s\n"
                   "    behind others: gdsum waits for nodes 0, 1 to come to it.");
}

static void all_wait_for_any(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(512);
    for (uint32_t i = 0; i < w->count; i++) {
        receives(w, i, 7, WAITFOR_ANY)->line = "main.c:42";
        w->nodes[i].since_ps = i * UINT64_C(1000000000);
    }
    expect_text(w,
                "  knot: nodes 0-511 wait for messages that only they could send\n"
                "  nodes 0-511: crecv(7) since 0 s to 511 ms (main.c:42)\n"
                "    knot: It waits for type 7 from any node; each other node could send it, but none has.\n"
                "    One of them has to send before it receives.");
}

static void all_wait_for_any_where_a_host_may_be_missing(void **state)
{
    (void)state;
    for (uint32_t count = 2; count <= 3; count++) {
        struct waitfor *w = waitfor_new(count);
        for (uint32_t i = 0; i < count; i++)
            receives(w, i, 7, WAITFOR_ANY);
        w->may_lack_host = true;
        waitfor_analyse(w);
        assert_string_equal(w->nodes[0].remedy, "A node has to send first, or a host program: touchstone run "
                                                "--host HOST PROGRAM");
        waitfor_free(w);
    }
}

static void expect_why(const struct waitfor *w, uint32_t i, const char *sentence)
{
    assert_string_equal(w->nodes[i].why, sentence);
}

/* Of those that live, each has a list of the others, which parts the run of nodes that it is in. */
static void some_wait_for_any_and_others_have_ended(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(8);
    w->nodes[7].is_host = true, w->nodes[7].name = "host";
    for (uint32_t i = 0; i < w->count; i++)
        receives(w, i, 7, WAITFOR_ANY);
    ends(w, 4), ends(w, 6);
    waitfor_analyse(w);
    expect_why(w, 0,
               "It waits for type 7 from any node; nodes 1-3, 5 and the host could send it, but none has.");
    expect_why(
        w, 2,
        "It waits for type 7 from any node; nodes 0, 1, 3, 5 and the host could send it, but none has.");
    expect_why(w, 5,
               "It waits for type 7 from any node; nodes 0-3 and the host could send it, but none has.");
    expect_why(w, 7, "It waits for type 7 from any node; nodes 0-3, 5 could send it, but none has.");
    waitfor_free(w);
}

static void one_waits_for_any_and_all_for_that(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(4);
    receives(w, 1, 7, WAITFOR_ANY);
    receives(w, 0, GSYNC, WAITFOR_ANY), receives(w, 2, GSYNC, WAITFOR_ANY), receives(w, 3, 9, 1);
    waitfor_analyse(w);
    assert_string_equal(waitfor_cause_name(w->nodes[1].cause), "orphan");
    assert_string_equal(waitfor_cause_name(w->nodes[0].cause), "behind others");
    assert_string_equal(waitfor_cause_name(w->nodes[3].cause), "behind others");
    assert_true(w->knot && !w->cycle);
    waitfor_free(w);
}

/* --- what a mailbox shows --- */

static void a_message_of_another_type(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(4);
    struct waitfor_node *n = receives(w, 1, 8, WAITFOR_ANY);
    waitfor_add_message(n, &FROM_2);
    ends(w, 0), ends(w, 2), receives(w, 3, 9, 1);
    expect_text(
        w,
        "  cycle: node 1 -> node 3 -> node 1\n"
        "  nodes 0, 2: ended at 2 us\n"
        "  node 1: crecv(8) since 0 s\n"
        "    wrong type: It waits for type 8 from any node; only node 3, which waits, too, could send it.\n"
        "      1 message is here: type 7 from node 2 (it wants type 8).\n"
        "    Compare the type here with that in the sender's call.\n"
        "  node 3: crecvx(9) since 0 s\n"
        "    cycle: It waits for type 9 from node 1, which waits, too.\n"
        "    One of the cycle has to send before it receives, or to post its receive (irecv) and go on.");
}

static void a_message_of_a_type_outside_of_a_set(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, INT32_MIN | 1 << 3 | 1 << 30, WAITFOR_ANY);
    waitfor_add_message(n, &FROM_2);
    receives(w, 0, 7, WAITFOR_ANY), receives(w, 2, 7, WAITFOR_ANY);
    waitfor_analyse(w);
    assert_string_equal(n->why,
                        "It waits for one of the types 3, 30 and above from any node; each other node "
                        "could send it, but none has.\n1 message is here: type 7 from node 2 (it wants "
                        "one of the types 3, 30 and above).");
    waitfor_free(w);
}

static void a_set_of_no_type(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(2);
    receives(w, 0, INT32_MIN, WAITFOR_ANY), receives(w, 1, 7, WAITFOR_ANY);
    waitfor_analyse(w);
    assert_string_equal(w->nodes[0].why, "It waits for no type from any node; only node 1, which waits, "
                                         "too, could send it.");
    waitfor_free(w);
}

static void a_host_that_is_not_there(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(2);
    receives(w, 0, 5, 2), ends(w, 1);
    expect_text(w,
                "  node 0: crecvx(5) since 0 s\n"
                "    orphan: It waits for type 5 from node 2, which would be the host, and there is none.\n"
                "    Send from a node, or from a host program: touchstone run --host HOST PROGRAM\n"
                "  node 1: ended at 2 us");
}

static void a_message_from_another_node(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, 7, 0);
    waitfor_add_message(n, &FROM_2);
    ends(w, 0), ends(w, 2);
    waitfor_analyse(w);
    assert_string_equal(waitfor_cause_name(n->cause), "wrong node");
    assert_string_equal(n->why, "It waits for type 7 from node 0, which ended at 2 us.\n"
                                "1 message is here: type 7 from node 2 (it wants node 0).");
    waitfor_free(w);
}

static void a_message_of_another_process_type(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, 7, 2);
    n->select.pid = 4;
    waitfor_add_message(n, &FROM_2);
    receives(w, 2, 7, WAITFOR_ANY);
    waitfor_analyse(w);
    assert_string_equal(waitfor_cause_name(n->cause), "wrong node");
    assert_non_null(strstr(n->why, "type 7 from node 2 (it wants process type 4, not 0)"));
    waitfor_free(w);
}

static void messages_of_global_operations_are_not_told(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 0, 7, WAITFOR_ANY);
    struct waitfor_message m = FROM_2;
    m.type = GSYNC;
    waitfor_add_message(n, &m);
    receives(w, 1, GSYNC + 1, WAITFOR_ANY), receives(w, 2, GSYNC + 1, WAITFOR_ANY);
    expect_cause(w, 0, "orphan");
}

static void of_many_messages_some_are_told(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, 8, WAITFOR_ANY);
    for (int i = 0; i < 100; i++)
        waitfor_add_message(n, &FROM_2);
    assert_int_equal(n->message_count, WAITFOR_MOST_MESSAGES);
    receives(w, 0, 7, 1), receives(w, 2, 7, 1);
    waitfor_analyse(w);
    assert_non_null(strstr(n->why, "100 messages are here: "));
    assert_non_null(strstr(n->why, ", and 96 more."));
    waitfor_free(w);
}

static void of_many_messages_of_the_library_none_is_told(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, 8, WAITFOR_ANY);
    struct waitfor_message m = FROM_2;
    m.type = GSYNC;
    for (int i = 0; i < 100; i++)
        waitfor_add_message(n, &m);
    receives(w, 0, 7, 1), receives(w, 2, 7, 1);
    waitfor_analyse(w);
    assert_null(strstr(n->why, "messages are here"));
    waitfor_free(w);
}

static void another_receive_took_it(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, 7, WAITFOR_ANY);
    struct waitfor_taken t = {.type = 7, .from = 2, .by = {-1, -1, -1}, .call = "crecv", .line = "a.c:3"};
    waitfor_add_taken(n, &t);
    ends(w, 0), ends(w, 2);
    waitfor_analyse(w);
    assert_string_equal(waitfor_cause_name(n->cause), "message taken");
    assert_string_equal(n->why, "It waits for type 7 from any node, and all other nodes have ended.\n"
                                "A message of type 7 from node 2 came at 0 s: crecv(-1) at a.c:3 took it.");
    waitfor_free(w);
}

static void another_receive_of_mpi_took_it(void **state)
{
    (void)state;
    enum { WORLD = 1 << 24 };
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, 7, 2);
    struct waitfor_taken t = {.type = 7, .from = 2, .pid = WORLD, .by = {-1, -1, WORLD}, .call = "MPI_Recv"};
    n->select.pid = WORLD;
    waitfor_add_taken(n, &t);
    ends(w, 0), ends(w, 2);
    waitfor_analyse(w);
    assert_non_null(strstr(
        n->why, "\nA message of tag 7 in MPI_COMM_WORLD from node 2 came at 0 s: MPI_Recv(-1) took it."));
    assert_non_null(strstr(n->remedy, "fewer tags or ranks"));
    waitfor_free(w);
}

/* A loop's crecv took what it was meant to. */
static void the_same_receive_took_it(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, -1, WAITFOR_ANY);
    struct waitfor_taken t = {.type = 7, .from = 2, .by = {-1, -1, -1}, .call = "crecv"};
    waitfor_add_taken(n, &t);
    receives(w, 0, GSYNC, WAITFOR_ANY), receives(w, 2, GSYNC, WAITFOR_ANY);
    expect_cause(w, 1, "orphan");
}

/* It was meant for the handler. */
static void a_handler_of_one_type_took_none_of_any_type(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, -1, WAITFOR_ANY);
    struct waitfor_taken t = {
        .fate = WAITFOR_HANDLED, .type = 7, .from = 2, .by = {7, -1, -1}, .call = "hrecv"};
    waitfor_add_taken(n, &t);
    receives(w, 0, GSYNC, WAITFOR_ANY), receives(w, 2, GSYNC, WAITFOR_ANY);
    expect_cause(w, 1, "orphan");
}

static void a_receive_under_way_has_it(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, 7, WAITFOR_ANY);
    struct waitfor_receive r = {.select = {7, -1, -1}, .filled = true, .type = 7, .from = 2};
    waitfor_add_receive(n, &r);
    ends(w, 0), ends(w, 2);
    expect_cause(w, 1, "message taken");
}

/* Node 1, with a handler that is due. */
static struct waitfor *with_due_handler(void)
{
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, 7, WAITFOR_ANY);
    struct waitfor_receive r = {
        .select = {5, -1, -1}, .has_handler = true, .filled = true, .type = 5, .from = 2};
    waitfor_add_receive(n, &r);
    n->due = 1;
    ends(w, 0), ends(w, 2);
    return w;
}

static void a_handler_is_masked(void **state)
{
    (void)state;
    struct waitfor *w = with_due_handler();
    w->nodes[1].masked = true;
    waitfor_analyse(w);
    assert_string_equal(waitfor_cause_name(w->nodes[1].cause), "handler masked");
    assert_non_null(strstr(w->nodes[1].why,
                           "1 handler is due and does not run, that of hrecv(5) for type 5 from "
                           "node 2: masktrap has masked handlers."));
    waitfor_free(w);
}

static void a_handler_that_may_run_is_no_cause(void **state)
{
    (void)state;
    expect_cause(with_due_handler(), 1, "node has ended");
}

static void no_room_at_the_receiver(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, 7, WAITFOR_ANY);
    n->call = "csend", n->what = WAITFOR_BUFFER, n->to = 2, n->to_bytes = 100;
    receives(w, 2, 9, 1);
    w->nodes[2].buffered_bytes = 950, w->nodes[2].buffer_bytes = 1000;
    waitfor_analyse(w);
    assert_string_equal(waitfor_cause_name(n->cause), "buffers full");
    assert_int_equal(w->cycle_count, 2);
    assert_string_equal(n->why,
                        "Its message of 100 bytes has no room at node 2, which waits, too.\n"
                        "That has 950 bytes of messages that no receive has asked for, and room for 1000 "
                        "in all.");
    waitfor_free(w);
}

static void a_probe_of_a_message_without_room(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    struct waitfor_node *n = receives(w, 1, 7, WAITFOR_ANY);
    struct waitfor_message m = FROM_2;
    m.held_back = true;
    waitfor_add_message(n, &m);
    receives(w, 0, 9, 1), receives(w, 2, 9, 1);
    expect_cause(w, 1, "buffers full");
}

static void a_node_has_ended_before_an_operation(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(4);
    receives(w, 0, GSYNC, WAITFOR_ANY), receives(w, 1, 7, WAITFOR_ANY), receives(w, 2, GSYNC, WAITFOR_ANY);
    ends(w, 3);
    waitfor_analyse(w);
    assert_string_equal(w->nodes[0].why,
                        "gsync waits for node 1 to come to it, and for node 3, which ended without it.");
    assert_string_equal(waitfor_cause_name(w->nodes[2].cause), "node has ended");
    assert_string_equal(waitfor_cause_name(w->nodes[1].cause), "orphan");
    waitfor_free(w);
}

static void the_host_waits_before_it_has_loaded_a_program(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    w->nodes[2].is_host = true, w->nodes[2].name = "host";
    receives(w, 2, 7, WAITFOR_ANY);
    w->nodes[0].state = w->nodes[1].state = WAITFOR_NO_PROGRAM;
    expect_text(w, "  host: crecv(7) since 0 s\n"
                   "    node has ended: It waits for type 7 from any node, and no node has a program.\n"
                   "    A host program loads the nodes (load) before it waits for them. Is this the host "
                   "program? touchstone run --host HOST PROGRAM\n"
                   "  nodes 0, 1: no program");
}

static void the_host_waits_for_ends(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(3);
    w->nodes[2].is_host = true, w->nodes[2].name = "host";
    receives(w, 2, 0, WAITFOR_ANY)->call = "waitall";
    w->nodes[2].has_type = false;
    w->nodes[2].what = WAITFOR_END, w->nodes[2].to = WAITFOR_ANY, w->nodes[2].of_all = true;
    receives(w, 0, 7, 2), ends(w, 1);
    expect_text(
        w, "  cycle: node 0 -> the host -> node 0\n"
           "  host: waitall since 0 s\n"
           "    cycle: It waits for the end of the program on each other node.\n"
           "    One of the cycle has to end, or to send, without waiting for the others.\n"
           "  node 0: crecvx(7) since 0 s\n"
           "    cycle: It waits for type 7 from the host, which waits, too.\n"
           "    One of the cycle has to send before it receives, or to post its receive (irecv) and go on.\n"
           "  node 1: ended at 2 us");
}

static void many_types_are_one_line(void **state)
{
    (void)state;
    struct waitfor *w = waitfor_new(100);
    for (uint32_t i = 0; i < w->count; i++)
        receives(w, i, i + 5, WAITFOR_ANY);
    char *text = text_of(w);
    assert_non_null(
        strstr(text, "\n  nodes 0-99: crecv of types 5 to 104 since 0 s\n    knot: for example node 0: "));
    free(text);
    waitfor_free(w);
}

static void more_states_than_are_told(void **state)
{
    (void)state;
    char lines[100][16];
    struct waitfor *w = waitfor_new(100);
    for (uint32_t i = 0; i < w->count; i++) {
        snprintf(lines[i], sizeof lines[i], "a.c:%u", i);
        receives(w, i, 7, WAITFOR_ANY)->line = lines[i];
    }
    char *text = text_of(w);
    assert_non_null(strstr(text, "\n  and 88 more states of nodes"));
    free(text);
    waitfor_free(w);
}

/* --- random graphs --- */

static uint64_t seed;

static uint32_t below(uint32_t n)
{
    seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((seed >> 33) % n);
}

/* Of the first of ten kinds: the fewer, the more nodes wait for a certain one. */
static void make_node(struct waitfor *w, uint32_t i, uint32_t kinds)
{
    uint32_t kind = below(kinds);
    struct waitfor_node *n = receives(w, i, 7, (long)below(w->count));
    if (kind == 4)
        n->select.node = WAITFOR_ANY;
    else if (kind == 5)
        n->select = (struct waitfor_select){GSYNC + below(3) * 64 + below(2), WAITFOR_ANY, WAITFOR_ANY};
    else if (kind == 6)
        n->what = WAITFOR_BUFFER, n->to = (long)below(w->count);
    else if (kind == 7)
        n->state = WAITFOR_ENDED;
    else if (kind == 8)
        n->state = WAITFOR_NO_PROGRAM;
    else if (kind == 9)
        n->what = WAITFOR_END, n->to = (long)below(w->count);
}

static struct waitfor *random_graph(uint32_t most)
{
    struct waitfor *w = waitfor_new(1 + below(most));
    uint32_t kinds = 5 + below(6);
    for (uint32_t i = 0; i < w->count; i++)
        make_node(w, i, kinds);
    return w;
}

static bool lives(const struct waitfor *w, uint32_t i)
{
    return w->nodes[i].state == WAITFOR_WAITS;
}

/* The operation whose message a node waits for; -1: none. */
static long operation(const struct waitfor *w, uint32_t i)
{
    const struct waitfor_node *n = &w->nodes[i];
    return lives(w, i) && n->what == WAITFOR_MESSAGE && n->select.typesel >= GSYNC
               ? (n->select.typesel - GSYNC) / 64
               : -1;
}

/* What the header says of edges, in the plainest form. *certain: there is no other node that would do. */
static bool edge(const struct waitfor *w, uint32_t a, uint32_t b, bool *certain)
{
    const struct waitfor_node *n = &w->nodes[a];
    uint32_t others = 0;
    for (uint32_t i = 0; i < w->count; i++)
        others += lives(w, i) && i != a;
    *certain = true;
    if (!lives(w, a))
        return false;
    if (operation(w, a) >= 0)
        return operation(w, b) != operation(w, a);
    if (n->what != WAITFOR_MESSAGE)
        return n->to == (long)b;
    if (n->select.node != WAITFOR_ANY)
        return n->select.node == (long)b;
    *certain = others == 1;
    return a != b && lives(w, b);
}

enum { MOST = 14, FAR = 1000 };

/* Shortest ways, Floyd and Warshall; of certain edges, or of all. */
static void find_ways(const struct waitfor *w, bool all, uint32_t d[MOST][MOST])
{
    for (uint32_t a = 0; a < w->count; a++)
        for (uint32_t b = 0; b < w->count; b++) {
            bool certain, is = edge(w, a, b, &certain);
            d[a][b] = is && (certain || all) ? 1 : FAR;
        }
    for (uint32_t k = 0; k < w->count; k++)
        for (uint32_t a = 0; a < w->count; a++)
            for (uint32_t b = 0; b < w->count; b++)
                if (d[a][k] + d[k][b] < d[a][b])
                    d[a][b] = d[a][k] + d[k][b];
}

static void check_cycle(const struct waitfor *w)
{
    uint32_t d[MOST][MOST], shortest = FAR;
    find_ways(w, false, d);
    for (uint32_t a = 0; a < w->count; a++)
        shortest = d[a][a] < shortest ? d[a][a] : shortest;
    assert_int_equal(w->cycle ? w->cycle_count : FAR, shortest);
    for (uint32_t k = 0; k < w->cycle_count; k++) {
        bool certain;
        assert_true(edge(w, w->cycle[k], w->cycle[(k + 1) % w->cycle_count], &certain) && certain);
        assert_true(w->nodes[w->cycle[k]].in_cycle);
        assert_true(w->cycle[0] <= w->cycle[k]);
    }
}

/* Holt: from each of a knot all of it can be reached, and nothing else. */
static void check_knot(const struct waitfor *w)
{
    uint32_t d[MOST][MOST], waiting = 0;
    bool knot = true;
    find_ways(w, true, d);
    for (uint32_t a = 0; a < w->count; a++) {
        waiting += lives(w, a);
        for (uint32_t b = 0; lives(w, a) && b < w->count; b++)
            knot = knot && (d[a][b] < FAR) == lives(w, b);
    }
    assert_int_equal(w->knot, knot && waiting > 1 && !w->cycle);
}

static void check_edges(const struct waitfor *w)
{
    for (uint32_t a = 0; a < w->count; a++)
        for (uint32_t b = 0; b < w->count; b++) {
            bool certain;
            assert_int_equal(waitfor_needs(w, a, b), edge(w, a, b, &certain));
        }
}

static void check_json(const struct waitfor *w)
{
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    waitfor_write_json(w, f);
    fclose(f);
    json_t *root = json_loadb(text, size, 0, NULL);
    assert_non_null(root);
    const json_t *cycle = json_object_get(root, "cycle"), *nodes = json_object_get(root, "nodes");
    assert_int_equal(json_array_size(cycle), w->cycle_count);
    for (uint32_t k = 0; k < w->cycle_count; k++)
        assert_int_equal(json_integer_value(json_array_get(cycle, k)), w->cycle[k]);
    assert_int_equal(json_array_size(nodes), w->count);
    for (uint32_t i = 0; i < w->count; i++) {
        const char *cause = json_string_value(json_object_get(json_array_get(nodes, i), "cause"));
        assert_true(lives(w, i) ? strcmp(cause, waitfor_cause_name(w->nodes[i].cause)) == 0 : !cause);
    }
    json_decref(root);
    free(text);
}

static void random_graphs(void **state)
{
    (void)state;
    uint32_t cycles = 0, knots = 0;
    for (seed = 1; cycles + knots < 20000; seed++) {
        uint64_t first = seed;
        struct waitfor *w = random_graph(MOST);
        waitfor_analyse(w);
        check_edges(w);
        check_cycle(w);
        check_knot(w);
        if (first % 64 == 0)
            check_json(w);
        cycles += w->cycle != NULL, knots += w->knot;
        waitfor_free(w);
        seed = first;
    }
    assert_true(cycles > 1000 && knots > 200);
}

/* --- many nodes --- */

/* Of all kinds of waits, the analysis and the reports of 4,096 nodes: within seconds, also with sanitizers
 * and where lines are counted. By the cube of the nodes they would take hours. */
static void many_nodes(void **state)
{
    (void)state;
    clock_t begun = clock();
    for (uint32_t kind = 0; kind < 4; kind++) {
        struct waitfor *w = waitfor_new(4096);
        for (uint32_t i = 0; i < w->count; i++)
            if (kind == 0)
                receives(w, i, 7, WAITFOR_ANY);
            else if (kind == 1)
                receives(w, i, i, (long)i - 1);
            else if (kind == 2)
                receives(w, i, GSYNC + i % 20 * 64, WAITFOR_ANY);
            else
                receives(w, i, i % 2 ? GSYNC : (long)i, i ? -1 : 1);
        free(text_of(w));
        check_json(w);
        waitfor_free(w);
    }
    assert_true(clock() - begun < 40 * CLOCKS_PER_SEC);
}

/* Of 100,000 nodes that wait for any other, or are in an operation, which one node has left: what is the same
 * for many is found once. By the square of the nodes this would take minutes. */
static void very_many_nodes(void **state)
{
    (void)state;
    clock_t begun = clock();
    for (uint32_t kind = 0; kind < 3; kind++) {
        struct waitfor *w = waitfor_new(100000);
        for (uint32_t i = 1; i < w->count; i++)
            receives(w, i, kind == 0 ? 7 : kind == 1 ? GSYNC : i % 2 ? GSYNC : 7, WAITFOR_ANY);
        ends(w, 0);
        free(text_of(w));
        waitfor_free(w);
    }
    assert_true(clock() - begun < 20 * CLOCKS_PER_SEC);
}

/* --- times ---------------------------------------------------------------------------------------------- */

static void times_are_those_of_other_reports(void **state)
{
    static const uint64_t TIMES[] = {0,          1,       999,         1000,          5025000,
                                     1967300000, 1000000, 29456789000, VT_SECOND - 1, 90 * VT_SECOND + 1000};
    (void)state;
    for (size_t i = 0; i < sizeof TIMES / sizeof *TIMES; i++) {
        char *text;
        size_t size;
        FILE *f = waitfor_stream(&text, &size);
        waitfor_print_time(f, TIMES[i]);
        fclose(f);
        assert_string_equal(text, virtual_time_moment(TIMES[i]).text);
        free(text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(three_in_a_cycle),
        cmocka_unit_test(a_node_that_waits_for_itself),
        cmocka_unit_test(the_shortest_of_two_cycles),
        cmocka_unit_test(two_operations_in_different_orders),
        cmocka_unit_test(all_wait_for_any),
        cmocka_unit_test(all_wait_for_any_where_a_host_may_be_missing),
        cmocka_unit_test(some_wait_for_any_and_others_have_ended),
        cmocka_unit_test(one_waits_for_any_and_all_for_that),
        cmocka_unit_test(a_message_of_another_type),
        cmocka_unit_test(a_message_of_a_type_outside_of_a_set),
        cmocka_unit_test(a_set_of_no_type),
        cmocka_unit_test(a_host_that_is_not_there),
        cmocka_unit_test(a_message_from_another_node),
        cmocka_unit_test(a_message_of_another_process_type),
        cmocka_unit_test(messages_of_global_operations_are_not_told),
        cmocka_unit_test(of_many_messages_some_are_told),
        cmocka_unit_test(of_many_messages_of_the_library_none_is_told),
        cmocka_unit_test(another_receive_took_it),
        cmocka_unit_test(another_receive_of_mpi_took_it),
        cmocka_unit_test(the_same_receive_took_it),
        cmocka_unit_test(a_handler_of_one_type_took_none_of_any_type),
        cmocka_unit_test(a_receive_under_way_has_it),
        cmocka_unit_test(a_handler_is_masked),
        cmocka_unit_test(a_handler_that_may_run_is_no_cause),
        cmocka_unit_test(no_room_at_the_receiver),
        cmocka_unit_test(a_probe_of_a_message_without_room),
        cmocka_unit_test(a_node_has_ended_before_an_operation),
        cmocka_unit_test(the_host_waits_before_it_has_loaded_a_program),
        cmocka_unit_test(the_host_waits_for_ends),
        cmocka_unit_test(many_types_are_one_line),
        cmocka_unit_test(more_states_than_are_told),
        cmocka_unit_test(random_graphs),
        cmocka_unit_test(many_nodes),
        cmocka_unit_test(very_many_nodes),
        cmocka_unit_test(times_are_those_of_other_reports),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
