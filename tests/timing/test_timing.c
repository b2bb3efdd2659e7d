/* test_timing.c - delays drawn from a seed, and those of schedules; reading schedules, with their errors. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>
#include "timing/draw_read.h"
#include "timing/plan_read.h"
#include "timing/timing.h"

enum { NODES = 4, DRAWS = 20000 };

static struct draw usual(uint64_t seed)
{
    struct draw d = draw_usual();
    d.seed = seed;
    return d;
}

/* --- draws --- */

static struct draw_node drawn(const struct draw *d, uint32_t nodes, uint32_t node)
{
    struct draw_node *all = draw_nodes(d, nodes), n = all[node];
    free(all);
    return n;
}

static void random_delays_are_within_bounds_half_of_them_0(void **state)
{
    (void)state;
    struct draw d = usual(1);
    struct draw_node n = drawn(&d, NODES, 2);
    int zeros = 0, ties = 0, long_ones = 0;
    for (uint64_t k = 0; k < DRAWS; k++) {
        vtime t = draw_message(&n, k);
        assert_true(t <= d.messages);
        zeros += t == 0, ties += t > 0 && t <= 1000, long_ones += t > d.messages / 2;
    }
    assert_in_range(zeros, DRAWS * 48 / 100, DRAWS * 52 / 100);
    assert_in_range(ties, DRAWS * 11 / 100, DRAWS * 14 / 100);
    assert_in_range(long_ones, DRAWS * 17 / 100, DRAWS * 21 / 100);
}

static void bounds_of_0_delay_nothing(void **state)
{
    (void)state;
    for (int method = DRAW_RANDOM; method <= DRAW_PCT; method++) {
        struct draw d = usual(7);
        d.method = (enum draw_method)method;
        d.messages = d.interrupts = d.start = 0, d.speed_ppm = 0;
        for (uint32_t i = 0; i < NODES; i++) {
            struct draw_node n = drawn(&d, NODES, i);
            assert_int_equal(draw_speed(&n) + draw_start(&n), 0);
            for (uint64_t k = 0; k < 100; k++)
                assert_int_equal(draw_message(&n, k) + draw_interrupt(&n, k), 0);
        }
    }
}

static void delays_differ_by_seed_node_count_and_purpose(void **state)
{
    (void)state;
    struct draw d = usual(1), other = usual(2);
    struct draw_node a = drawn(&d, NODES, 0), b = drawn(&d, NODES, 1), c = drawn(&other, NODES, 0);
    d.interrupts = other.interrupts = d.messages;
    int same_node = 0, same_seed = 0, same_purpose = 0, same_count = 0;
    for (uint64_t k = 0; k < 1000; k++) {
        vtime t = draw_message(&a, k);
        same_node += t && t == draw_message(&b, k);
        same_seed += t && t == draw_message(&c, k);
        same_purpose += t && t == draw_interrupt(&a, k);
        same_count += t && t == draw_message(&a, k + 1);
    }
    assert_true(same_node + same_seed + same_purpose + same_count < 8); /* a few of the tiny ones are equal */
}

static void pct_delays_by_priority_and_more_after_a_point(void **state)
{
    (void)state;
    struct draw d = usual(3);
    d.method = DRAW_PCT, d.depth = 1;
    bool behind[NODES] = {false};
    for (uint32_t i = 0; i < NODES; i++) {
        struct draw_node n = drawn(&d, NODES, i);
        assert_true(n.behind < NODES && !behind[n.behind]); /* priorities are a permutation */
        behind[n.behind] = true;
        for (uint64_t k = 0; k < 10; k++)
            assert_int_equal(draw_message(&n, k), d.messages * n.behind / (2 * (NODES - 1)));
    }
    d.depth = 2, d.length = 40;
    int dropped = 0;
    for (uint32_t i = 0; i < NODES; i++) {
        struct draw_node n = drawn(&d, NODES, i);
        vtime first = draw_message(&n, 0), last = draw_message(&n, 9);
        assert_true(first == last || last == d.messages || first == d.messages);
        dropped += last == d.messages;
        for (uint64_t k = 0; k < 9; k++)
            assert_true(draw_message(&n, k) <= draw_message(&n, k + 1));
    }
    assert_int_equal(dropped, 1); /* depth - 1 points, within the first length / nodes of a node */
}

/* Each node is the first, and the last, under some seed. */
static void pct_priorities_differ_by_seed(void **state)
{
    (void)state;
    int first[NODES] = {0}, last[NODES] = {0};
    for (uint64_t seed = 0; seed < 400; seed++) {
        struct draw d = usual(seed);
        d.method = DRAW_PCT;
        for (uint32_t i = 0; i < NODES; i++) {
            uint32_t behind = drawn(&d, NODES, i).behind;
            first[i] += behind == 0, last[i] += behind == NODES - 1;
        }
    }
    for (uint32_t i = 0; i < NODES; i++) {
        assert_in_range(first[i], 70, 130);
        assert_in_range(last[i], 70, 130);
    }
}

static void pct_priorities_of_many_nodes_are_drawn_soon(void **state)
{
    enum { MANY = 1 << 20 };
    (void)state;
    struct draw d = usual(1);
    d.method = DRAW_PCT;
    struct draw_node *all = draw_nodes(&d, MANY);
    uint64_t sum = 0;
    for (uint32_t i = 0; i < MANY; i++)
        sum += all[i].behind;
    assert_int_equal(sum, (uint64_t)MANY * (MANY - 1) / 2);
    free(all);
}

static void the_text_of_a_draw_is_read_back(void **state)
{
    (void)state;
    struct draw d, again;
    assert_null(draw_read("18446744073709551615,method=pct,depth=5,length=77,messages=1.5us,interrupts=0,"
                          "speed=0.0001%,start=3ps",
                          &d));
    assert_true(d.seed == UINT64_MAX && d.method == DRAW_PCT && d.depth == 5 && d.length == 77);
    assert_true(d.messages == 1500000 && d.interrupts == 0 && d.speed_ppm == 1 && d.start == 3);
    char *text = draw_text(&d);
    assert_non_null(strstr(text, ",messages=1500ns,interrupts=0s,"));
    assert_null(draw_read(text, &again));
    assert_memory_equal(&d, &again, sizeof d);
    free(text);
}

static void wrong_texts_of_draws_are_refused(void **state)
{
    static const char *const WRONG[] = {"",
                                        "x",
                                        "-1",
                                        "1.5",
                                        "1,",
                                        "1,depth",
                                        "1,depth=0",
                                        "1,depth=101",
                                        "1,length=0",
                                        "1,speed=2",
                                        "1,speed=-1%",
                                        "1,speed=1001%",
                                        "1,messages=3m",
                                        "1,method=dfs",
                                        "1,colour=red",
                                        "1,start=-1us"};
    struct draw d;
    (void)state;
    for (size_t i = 0; i < sizeof WRONG / sizeof *WRONG; i++) {
        char *wrong = draw_read(WRONG[i], &d);
        if (!wrong)
            fail_msg("'%s' was read", WRONG[i]);
        free(wrong);
    }
}

/* --- schedules --- */

static const char *path;

static struct plan *read_text(const char *text, char **error)
{
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
    *error = NULL;
    return plan_read(path, error);
}

static struct plan *must_read(const char *text)
{
    char *error;
    struct plan *p = read_text(text, &error);
    if (!p)
        fail_msg("%s", error);
    return p;
}

static void delays_of_a_schedule_come_in_the_order_of_counts(void **state)
{
    (void)state;
    struct plan *p = must_read("touchstone-schedule 1\n# a comment\nnodes 2\n"
                               "message 1 3 30\nmessage 1 1 10 to=0 type=7 # another\n\n"
                               "interrupt 1 0 5\nspeed 0 1000000\nstart host 99\n");
    struct timing *t = timing_new(NULL, p, 2);
    const vtime messages[] = {0, 10, 0, 30, 0};
    for (int i = 0; i < 5; i++) {
        assert_int_equal(timing_next_message(t, 1), messages[i]);
        assert_int_equal(timing_next_message(t, 0), 0);
        assert_int_equal(timing_next_interrupt(t, 1), i ? 0 : 5);
    }
    assert_int_equal(timing_clock_hz(t, 0, 40000000), 20000000);
    assert_int_equal(timing_clock_hz(t, 1, 40000000), 40000000);
    assert_int_equal(timing_start(t, TIMING_HOST), 99);
    assert_int_equal(timing_start(t, 0), 0);
    timing_free(t);
    plan_free(p);
}

static void the_same_draws_come_from_a_timing(void **state)
{
    (void)state;
    struct draw d = usual(11);
    struct timing *t = timing_new(&d, NULL, NODES);
    struct draw_node n = drawn(&d, NODES + 1, 3), host = drawn(&d, NODES + 1, NODES);
    for (uint64_t k = 0; k < 50; k++) {
        assert_int_equal(timing_next_message(t, 3), draw_message(&n, k));
        assert_int_equal(timing_next_interrupt(t, TIMING_HOST), draw_interrupt(&host, k));
    }
    timing_free(t);
}

static void orders_are_found_by_receive_and_by_message(void **state)
{
    (void)state;
    struct plan *p = must_read("touchstone-schedule 1\nnodes 3\norders\nmatch 0 4 2 1\nmatch 0 2 host 0\n"
                               "match 0 9 1 5\nhandler 0 1 7\n");
    const struct plan_node *n = &p->node[0];
    assert_int_equal(plan_find(&n->matches, 4)->nth, 1);
    assert_null(plan_find(&n->matches, 3));
    assert_int_equal(plan_find_message(&n->by_message, 3, 0)->k, 2);
    assert_int_equal(plan_find_message(&n->by_message, 1, 5)->k, 9);
    assert_null(plan_find_message(&n->by_message, 1, 4));
    assert_int_equal(plan_find(&n->handlers, 1)->calls, 7);
    assert_null(plan_find(&p->node[1].matches, 4));
    plan_free(p);
}

static void without_orders_matches_only_tell(void **state)
{
    (void)state;
    struct plan *p = must_read("touchstone-schedule 1\nnodes 3\ndelays\nmatch 0 4 2 1\nhandler 0 1 7\n"
                               "message 0 0 0\nleft 1 0 3 i=4\n");
    assert_int_equal(p->node[0].matches.count + p->node[0].handlers.count, 0);
    assert_int_equal(p->node[0].messages.count, 0); /* a delay of 0 is none */
    plan_free(p);
}

static void the_program_is_known_if_it_is_named(void **state)
{
    (void)state;
    struct plan *p = must_read("touchstone-schedule 1\nprogram 4294967295 file=race\nnodes 3\n");
    assert_true(p->has_program && p->program == UINT32_MAX);
    plan_free(p);
    p = must_read("touchstone-schedule 1\nnodes 3\n");
    assert_false(p->has_program);
    plan_free(p);
}

static void errors_name_file_and_line(void **state)
{
    static const struct {
        const char *text, *error; /* the error's end, behind the path */
    } WRONG[] = {
        {"", ":1: this is no schedule: one begins with the line 'touchstone-schedule 1'"},
        {"nodes 2\n", ":1: this is no schedule: one begins with the line 'touchstone-schedule 1'"},
        {"touchstone-schedule 2\n", ":1: this touchstone reads schedules of format 1, not 2"},
        {"touchstone-schedule 1\n", ":2: there is no line 'nodes COUNT'"},
        {"touchstone-schedule 1\nspeed 0 1\n", ":2: speed: a line 'nodes COUNT' must come before"},
        {"touchstone-schedule 1\nnodes 0\n", ":2: nodes: a run has at least 1"},
        {"touchstone-schedule 1\nprogram 7 file=a\nprogram 7\n", ":3: program: stands twice"},
        {"touchstone-schedule 1\nnodes x\n", ":2: nodes: the number of nodes is a whole number, not 'x'"},
        {"touchstone-schedule 1\nnodes 2\nnodes 2\n", ":3: nodes: stands twice"},
        {"touchstone-schedule 1\nnodes 2\nspeed 2 1\n",
         ":3: speed: there is no node 2: nodes are 0 to 1, or host"},
        {"touchstone-schedule 1\nnodes 2\nspeed 1 -1\n",
         ":3: speed: parts per million is a whole number, not '-1'"},
        {"touchstone-schedule 1\nnodes 2\nstart 1\n", ":3: such a line is 'start NODE PICOSECONDS'"},
        {"touchstone-schedule 1\nnodes 2\nstart 1 5\nstart 1 5\n", ":4: another line says this of the same"},
        {"touchstone-schedule 1\nnodes 2\nmessage 1 7 5\n\nmessage 1 7 6\n",
         ":5: another line says this of the same"},
        {"touchstone-schedule 1\nnodes 2\nmessage 1 7 5 6\n",
         ":3: such a line is 'message NODE K PICOSECONDS'"},
        {"touchstone-schedule 1\nnodes 2\nmessage 1 7 99999999999999999999\n",
         ":3: message: a delay in picoseconds is a whole number, not '99999999999999999999'"},
        {"touchstone-schedule 1\nnodes 2\nmatch 1 7 0 0\n",
         ":3: match: a line must say before whether such lines must be kept, 'orders', or only tell of a "
         "run, 'delays'"},
        {"touchstone-schedule 1\nnodes 2\norders\ndelays\n",
         ":4: delays: one line, 'orders' or 'delays', is enough"},
        {"touchstone-schedule 1\nnodes 2\norders\nmatch 1 7 0 0\nmatch 1 8 0 0\n",
         ":5: another line says this of the same"},
        {"touchstone-schedule 1\nnodes 2\nthrow 1\n", ":3: a schedule has no lines 'throw'"},
        {"touchstone-schedule 1\nnodes 2\nmatch 1 2 3 4 5\n", ":3: there are too many words: '5'"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof WRONG / sizeof *WRONG; i++) {
        char *error;
        assert_null(read_text(WRONG[i].text, &error));
        assert_int_equal(strncmp(error, path, strlen(path)), 0);
        assert_string_equal(error + strlen(path), WRONG[i].error);
        free(error);
    }
}

static void a_file_that_is_not_there_is_an_error(void **state)
{
    char *error;
    (void)state;
    assert_null(plan_read("/nowhere/x", &error));
    assert_string_equal(error, "/nowhere/x cannot be read: No such file or directory");
    free(error);
}

static int begin(void **state)
{
    static char name[] = "/tmp/test-timing-XXXXXX";
    int fd = mkstemp(name);
    (void)state;
    path = name;
    return fd < 0 ? -1 : close(fd);
}

static int end(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_delays_are_within_bounds_half_of_them_0),
        cmocka_unit_test(bounds_of_0_delay_nothing),
        cmocka_unit_test(delays_differ_by_seed_node_count_and_purpose),
        cmocka_unit_test(pct_delays_by_priority_and_more_after_a_point),
        cmocka_unit_test(pct_priorities_differ_by_seed),
        cmocka_unit_test(pct_priorities_of_many_nodes_are_drawn_soon),
        cmocka_unit_test(the_text_of_a_draw_is_read_back),
        cmocka_unit_test(wrong_texts_of_draws_are_refused),
        cmocka_unit_test(delays_of_a_schedule_come_in_the_order_of_counts),
        cmocka_unit_test(the_same_draws_come_from_a_timing),
        cmocka_unit_test(orders_are_found_by_receive_and_by_message),
        cmocka_unit_test(without_orders_matches_only_tell),
        cmocka_unit_test(the_program_is_known_if_it_is_named),
        cmocka_unit_test(errors_name_file_and_line),
        cmocka_unit_test(a_file_that_is_not_there_is_an_error),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
