/* test_show.c - what touchstone trace show draws: the numbers behind each display, by hand and by brute
 * force, and pictures whose areas are the shares of time. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "made_trace.h"
#include "lab/draw/axes.h"
#include "lab/show/channel_use.h"
#include "lab/show/displays.h"
#include "lab/draw/heat.h"
#include "lab/show/message_lengths.h"
#include "lab/show/message_queues.h"
#include "lab/show/message_sample.h"
#include "lab/show/stacked.h"
#include "lab/draw/palette.h"
#include "lab/draw/picture_file.h"
#include "lab/draw/state_times.h"

static void drop(struct trace *t)
{
    for (int32_t i = 0; i < t->name_count; i++)
        free(t->names[i]);
    void *const parts[] = {t->names,    t->classes, t->nodes,    t->calls, t->waits,
                           t->handlers, t->systems, t->messages, t->blocks};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        free(parts[i]);
}

#define assert_text(expected, made)                                                                          \
    do {                                                                                                     \
        char *text_ = (made);                                                                                \
        assert_string_equal(text_, expected);                                                                \
        free(text_);                                                                                         \
    } while (0)

static uint64_t next_random(uint64_t *state)
{
    *state = *state * UINT64_C(6364136223846793005) + 1442695040888963407;
    return *state >> 33;
}

/* --- bins --- */

static void bins_share_what_they_overlap(void **state)
{
    (void)state;
    struct time_bins b = {100, 107, 3}; /* edges 100, 102, 104, 107 */
    double sums[3] = {0};
    assert_int_equal(time_bins_edge(&b, 1), 102);
    assert_int_equal(time_bins_edge(&b, 3), 107);
    time_bins_add(&b, sums, 1, 0, 103, 1);
    assert_true(sums[0] == 2 && sums[1] == 1 && sums[2] == 0);
    time_bins_add(&b, sums, 1, 106, VT_NEVER, 2);
    time_bins_add(&b, sums, 1, 104, 104, 9);
    time_bins_add(&b, sums, 1, 200, 300, 9);
    assert_true(sums[0] == 2 && sums[1] == 1 && sums[2] == 2);
}

static void bins_of_days_do_not_overflow(void **state)
{
    (void)state;
    vtime day = 86400 * VT_SECOND;
    struct time_bins b = {day, 200 * day, 1000};
    double sums[1000] = {0}, all = 0;
    time_bins_add(&b, sums, 1, 0, VT_NEVER, 1);
    for (int i = 0; i < 1000; i++) {
        assert_true(fabs(sums[i] - 0.199 * (double)day) <= 1);
        all += sums[i];
    }
    assert_true(fabs(all / (199 * (double)day) - 1) < 1e-12);
}

/* --- rows --- */

static void few_nodes_have_a_row_each_many_share(void **state)
{
    (void)state;
    struct trace t = made_trace(128, 10);
    t.nodes[5].traced = false;
    struct node_rows r = node_rows_make(&t);
    assert_int_equal(r.count, 127);
    assert_int_equal(r.row[5], TRACE_NONE);
    assert_int_equal(r.row[6], 5);
    assert_text("6", node_rows_label(&r, &t, 5));
    assert_text("127 nodes", node_rows_text(&r, "rows"));
    node_rows_free(&r);
    drop(&t);
}

static void classes_are_powers_of_two_and_the_host_is_apart(void **state)
{
    (void)state;
    struct trace t = made_trace(128, 10);
    struct trace_node host = {.name = "host", .traced = true};
    t.node_count = 300; /* of a cube of 512 */
    topo_hypercube(&t.topo, 299, 9);
    topo_add_host(&t.topo);
    for (int32_t i = 128; i < 299; i++)
        t.nodes[i] = (struct trace_node){.address = (uint32_t)i, .traced = true};
    for (int32_t i = 0; i < 299; i++)
        t.nodes[i].calls = 1;
    t.nodes[299] = host, t.nodes[299].address = topo_host(&t.topo);
    struct node_rows r = node_rows_make(&t), each = node_rows_single(&t);
    assert_int_equal(r.per, 8); /* 4 would be 75 rows */
    assert_int_equal(r.count, 39);
    assert_int_equal(r.classes[37].size, 3);
    assert_int_equal(r.classes[38].size, 1);
    assert_int_equal(r.row[298], 37);
    assert_int_equal(r.row[299], 38);
    assert_text("8\u201315", node_rows_label(&r, &t, 1));
    assert_text("host", node_rows_label(&r, &t, 38));
    r.classes[38].last = 10000; /* long ranges leave a picture's margin */
    assert_text("8\u2026", node_rows_label(&r, &t, 1));
    r.classes[38].last = 299;
    assert_string_equal(activity_name(&t, ACTIVITIES), "no program");
    assert_string_equal(stacked_whole(&t), "Of all time: ");
    assert_text("299 nodes and the host in 38 rows of 8", node_rows_text(&r, "rows"));
    assert_int_equal(each.count, 300);
    node_rows_free(&each);
    t.nodes[298].calls = 0; /* the host did not get it as a part of its cube */
    each = node_rows_single(&t);
    assert_int_equal(each.count, 299);
    assert_int_equal(each.row[298], TRACE_NONE);
    node_rows_free(&r);
    node_rows_free(&each);
    drop(&t);
}

/* What node 20, which serves the others, did was an eighth of a row that it shared. */
static void of_many_nodes_those_that_serve_have_a_row_each(void **state)
{
    (void)state;
    struct trace t = made_trace(512, VT_SECOND);
    for (int32_t n = 0; n < 512; n++)
        if (n != 20) {
            int32_t send = made_call(&t, n, "csend", TRACE_SENDS, 1, 0, 10);
            made_message(&t, send, TRACE_NONE, 20, 1, 10, 10, 20, 30);
        }
    struct node_rows r = node_rows_make(&t);
    assert_int_equal(r.count, 66);
    assert_text("16\u201319", node_rows_label(&r, &t, 2));
    assert_text("20", node_rows_label(&r, &t, 3));
    assert_text("21\u201323", node_rows_label(&r, &t, 4));
    assert_text("24\u201331", node_rows_label(&r, &t, 5));
    assert_text("512 nodes in 65 rows of 8, those that serve the others apart", node_rows_text(&r, "rows"));
    assert_true(node_rows_heighten(&r, &t, 4) == 69);
    assert_true(fabs(node_rows_edge(&r, 4) - node_rows_edge(&r, 3) - 4 / 69.0) < 1e-12);
    node_rows_free(&r);
    for (int32_t i = 0; i < t.message_count; i++)
        t.messages[i].to = i % 17; /* too many rows */
    r = node_rows_make(&t);
    assert_int_equal(r.count, 64);
    node_rows_free(&r);
    drop(&t);
}

/* --- activities --- */

/* Node 0 computes 0-10 and 40-100, and waits 15-35 of a call from 10 to 40; node 1 computes, and ends at
 * 60. */
static struct trace two_nodes(void)
{
    struct trace t = made_trace(2, 100);
    made_call(&t, 0, "crecv", TRACE_RECEIVES, 1, 10, 40);
    made_wait(&t, 15, 35);
    t.nodes[1].end = 60;
    return t;
}

/* Node 1 has an end of all messages; the others one of each. */
static void rows_of_hosts_are_higher(void **state)
{
    (void)state;
    struct trace t = made_trace(8, VT_SECOND);
    for (int32_t n = 0; n < 8; n++)
        if (n != 1) {
            int32_t send = made_call(&t, n, "csend", TRACE_SENDS, 1, 0, 10);
            made_message(&t, send, TRACE_NONE, 1, 1, 10, 10, 20, 30);
        }
    struct node_rows r = node_rows_make(&t);
    assert_true(node_rows_edge(&r, 1) == 1 / 8.0);
    assert_true(node_rows_heighten(&r, &t, 4) == 11);
    assert_true(fabs(node_rows_edge(&r, 1) - 1 / 11.0) < 1e-12);
    assert_true(fabs(node_rows_edge(&r, 2) - 5 / 11.0) < 1e-12);
    assert_true(fabs(node_rows_edge(&r, 8) - 1) < 1e-12);
    node_rows_free(&r);
    t.message_count = 0; /* then nobody serves */
    r = node_rows_make(&t);
    assert_true(node_rows_heighten(&r, &t, 4) == 8);
    assert_null(r.edge);
    node_rows_free(&r);
    drop(&t);
}

static void activities_by_hand(void **state)
{
    (void)state;
    struct trace t = two_nodes();
    struct node_rows r = node_rows_make(&t);
    struct state_times s = state_times_make(&t, &r, (struct time_bins){0, 100, 2}),
                       all = state_times_total(&s);
    const double expected[2][2][ACTIVITIES] = {
        {{[ACTIVITY_COMPUTING] = 20, [ACTIVITY_CALL] = 10, [ACTIVITY_WAITING] = 20},
         {[ACTIVITY_COMPUTING] = 50}},
        {{[ACTIVITY_COMPUTING] = 50}, {[ACTIVITY_COMPUTING] = 10}}};
    for (int row = 0; row < 2; row++)
        for (uint32_t bin = 0; bin < 2; bin++)
            assert_memory_equal(state_times_at(&s, row, bin), expected[row][bin], sizeof expected[row][bin]);
    assert_true(state_times_at(&all, 0, 1)[ACTIVITY_COMPUTING] == 60);
    state_times_free(&s);
    state_times_free(&all);
    node_rows_free(&r);
    drop(&t);
}

static void a_handler_s_computing_is_told_apart(void **state)
{
    (void)state;
    struct trace_piece p = {.state = TRACE_COMPUTING};
    assert_int_equal(activity_of(&p), ACTIVITY_COMPUTING);
    p.in_handler = true;
    assert_int_equal(activity_of(&p), ACTIVITY_HANDLER);
    p.state = TRACE_WAITING;
    assert_int_equal(activity_of(&p), ACTIVITY_WAITING);
    p.state = TRACE_ENDED;
    assert_int_equal(activity_of(&p), ACTIVITIES);
}

enum { BRUTE_NODES = 130, BRUTE_END = 500, BRUTE_BINS = 7 };

/* Each node: calls after each other, with a wait in each. */
static struct trace random_calls(uint64_t *seed)
{
    struct trace t = made_trace(128, BRUTE_END);
    t.from = 30, t.to = 470;
    for (int32_t n = 0; n < 128; n++) {
        vtime at = next_random(seed) % 50;
        for (int k = 0; k < 6; k++) {
            vtime wait = at + next_random(seed) % 20, idle = wait + next_random(seed) % 40;
            vtime end = idle + next_random(seed) % 20;
            made_call(&t, n, "crecv", TRACE_RECEIVES, 1, at, end);
            made_wait(&t, wait, idle);
            at = end + next_random(seed) % 60;
        }
    }
    return t;
}

/* What a node does in a picosecond, from the calls alone. */
static enum activity activity_at(const struct trace *t, int32_t node, vtime at)
{
    for (int32_t i = 0; i < t->call_count; i++) {
        const struct trace_call *c = &t->calls[i];
        const struct trace_wait *w = &t->waits[c->first_wait];
        if (c->node == node && at >= c->begin && at < c->end)
            return at >= w->begin && at < w->end ? ACTIVITY_WAITING : ACTIVITY_CALL;
    }
    return ACTIVITY_COMPUTING;
}

static void activities_by_brute_force(void **state)
{
    (void)state;
    uint64_t seed = 22;
    struct trace t = random_calls(&seed);
    struct node_rows r = node_rows_make(&t);
    struct time_bins bins = {t.from, t.to, BRUTE_BINS};
    struct state_times s = state_times_make(&t, &r, bins);
    double sums[BRUTE_BINS][ACTIVITIES] = {{0}};
    for (int32_t n = 0; n < 128; n += 9) {
        memset(sums, 0, sizeof sums);
        for (vtime at = t.from; at < t.to; at++)
            sums[((at - t.from + 1) * BRUTE_BINS - 1) / (t.to - t.from)][activity_at(&t, n, at)] += 1;
        for (uint32_t bin = 0; bin < BRUTE_BINS; bin++)
            assert_memory_equal(state_times_at(&s, n, bin), sums[bin], sizeof sums[bin]);
    }
    state_times_free(&s);
    node_rows_free(&r);
    drop(&t);
}

/* --- messages --- */

/* Three nodes. 0 sends to 1 twice (10 and 1,000 bytes), 1 to 2 once (0 bytes), and 2 to an I/O node (20
 * bytes). */
static struct trace four_messages(void)
{
    struct trace t = made_trace(3, 1000);
    int32_t a = made_call(&t, 0, "csend", TRACE_SENDS, 1, 0, 10),
            b = made_call(&t, 0, "csend", TRACE_SENDS, 1, 20, 30);
    int32_t c = made_call(&t, 1, "csend", TRACE_SENDS, 1, 0, 10);
    int32_t first = made_call(&t, 1, "crecv", TRACE_RECEIVES, 1, 400, 450);
    int32_t second = made_call(&t, 1, "crecv", TRACE_RECEIVES, 1, 500, 600);
    int32_t d = made_call(&t, 2, "cwrite", TRACE_FILES, 1, 0, 10);
    made_message(&t, a, first, 1, 10, 10, 12, 20, 100);
    made_message(&t, b, second, 1, 1000, 30, 35, 200, 300);
    t.messages[1].is_long = true;
    made_message(&t, c, TRACE_NONE, 2, 0, 10, 12, 20, 50);
    made_message(&t, d, TRACE_NONE, TRACE_NONE, 20, 900, 901, 902, VT_NEVER);
    return t;
}

static void the_matrix_has_each_message_once(void **state)
{
    (void)state;
    struct trace t = four_messages();
    struct node_rows r = node_rows_make(&t);
    struct message_matrix m = message_matrix_make(&t, &r);
    assert_int_equal(m.size, 4);
    assert_true(m.others);
    assert_int_equal(message_matrix_at(&m, 0, 1)->messages, 2);
    assert_int_equal(message_matrix_at(&m, 0, 1)->bytes, 1010);
    assert_int_equal(message_matrix_at(&m, 1, 0)->messages, 0);
    assert_int_equal(message_matrix_at(&m, 1, 2)->messages, 1);
    assert_int_equal(message_matrix_at(&m, 2, 3)->bytes, 20);
    assert_int_equal(m.messages, 4);
    assert_int_equal(m.bytes, 1030);
    message_matrix_free(&m);
    t.from = 20, t.to = 800; /* only the second was sent then */
    m = message_matrix_make(&t, &r);
    assert_int_equal(m.size, 3);
    assert_int_equal(m.messages, 1);
    message_matrix_free(&m);
    node_rows_free(&r);
    drop(&t);
}

static void nodes_that_are_not_shown_are_others(void **state)
{
    (void)state;
    struct trace t = four_messages();
    t.nodes[1].traced = t.nodes[2].traced = false;
    struct node_rows r = node_rows_make(&t);
    struct message_matrix m = message_matrix_make(&t, &r);
    assert_int_equal(m.size, 2);
    assert_int_equal(m.messages, 2); /* that from 1 to 2 has no end in the picture */
    assert_int_equal(message_matrix_at(&m, 0, 1)->messages, 2);
    message_matrix_free(&m);
    node_rows_free(&r);
    drop(&t);
}

static void lengths_are_classed_by_powers_of_two(void **state)
{
    (void)state;
    static const struct {
        uint64_t bytes;
        int class;
    } CASES[] = {{0, 0}, {1, 1}, {2, 2}, {3, 2}, {4, 3}, {511, 9}, {512, 10}, {UINT64_MAX, 64}};
    for (size_t i = 0; i < sizeof CASES / sizeof *CASES; i++)
        assert_int_equal(length_class(CASES[i].bytes), CASES[i].class);
    struct trace t = four_messages();
    struct node_rows r = node_rows_make(&t);
    struct message_lengths l = message_lengths_make(&t, &r);
    assert_int_equal(l.messages, 4);
    assert_int_equal(l.shortest, 0);
    assert_int_equal(l.median, 10);
    assert_int_equal(l.longest, 1000);
    assert_int_equal(l.first_class, 0);
    assert_int_equal(l.last_class, 10);
    assert_int_equal(l.sums[10][1].messages, 1);
    assert_int_equal(l.sums[10][0].messages, 0);
    assert_int_equal(l.sums[5][0].bytes, 20);
    node_rows_free(&r);
    drop(&t);
}

static void queues_by_hand(void **state)
{
    (void)state;
    struct trace t = four_messages();
    struct node_rows r = node_rows_make(&t);
    /* Node 1: waiting 100-450 and 300-600, on the way 10-100 and 30-300. Node 2: waiting from 50 on. */
    struct message_queues q = message_queues_make(&t, &r, (struct time_bins){0, 1000, 10}, false);
    assert_true(message_queues_mean(&q, 1, 0, QUEUE_WAITING) == 0);
    assert_true(message_queues_mean(&q, 1, 0, QUEUE_COMING) == 1.6);
    assert_true(message_queues_mean(&q, 1, 3, QUEUE_WAITING) == 2);
    assert_true(message_queues_mean(&q, 1, 4, QUEUE_WAITING) == 1.5);
    assert_true(message_queues_mean(&q, 2, 0, QUEUE_WAITING) == 0.5);
    assert_true(message_queues_mean(&q, 2, 9, QUEUE_WAITING) == 1);
    assert_int_equal(q.longest.length, 2);
    assert_int_equal(q.longest.node, 1);
    assert_int_equal(q.longest.time, 300);
    message_queues_free(&q);
    q = message_queues_make(&t, &r, (struct time_bins){0, 1000, 1}, true);
    assert_true(message_queues_mean(&q, 1, 0, QUEUE_WAITING) == (10 * 350 + 1000 * 300) / 1000.0);
    assert_int_equal(q.longest.length, 1010);
    message_queues_free(&q);
    node_rows_free(&r);
    drop(&t);
}

static void a_message_taken_as_another_comes_is_gone(void **state)
{
    (void)state;
    struct trace t = four_messages();
    t.messages[0].taken = 300; /* when the second is complete */
    struct node_rows r = node_rows_make(&t);
    struct message_queues q = message_queues_make(&t, &r, (struct time_bins){0, 1000, 10}, false);
    assert_int_equal(q.longest.length, 1);
    assert_int_equal(q.longest.node, 1);
    assert_int_equal(q.longest.time, 100);
    message_queues_free(&q);
    node_rows_free(&r);
    drop(&t);
}

static void queues_by_brute_force(void **state)
{
    (void)state;
    uint64_t seed = 7;
    struct trace t = made_trace(4, 300);
    int32_t call = made_call(&t, 0, "csend", TRACE_SENDS, 1, 0, 1);
    int most = 0, most_node = 0;
    for (int i = 0; i < 200; i++) {
        vtime sent = next_random(&seed) % 280, complete = sent + next_random(&seed) % 30;
        int32_t m = made_message(&t, call, TRACE_NONE, (int32_t)(next_random(&seed) % 4), 1, sent, sent, sent,
                                 complete);
        t.messages[m].taken = complete + next_random(&seed) % 60;
    }
    struct node_rows r = node_rows_make(&t);
    struct message_queues q = message_queues_make(&t, &r, (struct time_bins){0, 300, 300}, false);
    for (int32_t n = 0; n < 4; n++)
        for (uint32_t at = 0; at < 300; at++) {
            int count = 0;
            for (const struct trace_message *m = t.messages; m < t.messages + t.message_count; m++)
                count += m->to == n && m->complete <= at && at < m->taken;
            assert_true(message_queues_mean(&q, n, at, QUEUE_WAITING) == count);
            if (count > most)
                most = count, most_node = n;
        }
    assert_int_equal(q.longest.length, most);
    assert_int_equal(q.longest.node, most_node);
    message_queues_free(&q);
    node_rows_free(&r);
    drop(&t);
}

static void a_sample_is_even_and_always_the_same(void **state)
{
    (void)state;
    struct trace t = made_trace(2, 1000);
    int32_t call = made_call(&t, 0, "csend", TRACE_SENDS, 1, 0, 1);
    for (vtime i = 0; i < 900; i++)
        made_message(&t, call, TRACE_NONE, 1, 1, i, i, i, i + 1);
    struct node_rows r = node_rows_make(&t);
    struct message_sample s = message_sample_make(&t, &r, 90), again = message_sample_make(&t, &r, 90);
    assert_int_equal(s.count, 90);
    assert_int_equal(s.of, 900);
    bool in_step = true;
    for (size_t i = 0; i < s.count; i++) {
        assert_in_range(s.list[i], 10 * i, 10 * i + 9);
        in_step = in_step && s.list[i] % 10 == s.list[0] % 10;
    }
    assert_false(in_step);
    assert_memory_equal(s.list, again.list, s.count * sizeof *s.list);
    message_sample_free(&s);
    message_sample_free(&again);
    s = message_sample_make(&t, &r, 5000);
    assert_int_equal(s.count, 900);
    assert_int_equal(s.list[899], 899);
    message_sample_free(&s);
    node_rows_free(&r);
    drop(&t);
}

/* --- channels --- */

static void channels_are_held_along_the_path(void **state)
{
    (void)state;
    struct trace t = made_trace(4, 1000);
    int32_t call = made_call(&t, 0, "csend", TRACE_SENDS, 1, 0, 1);
    made_message(&t, call, TRACE_NONE, 3, 1, 100, 100, 350, 400);
    t.messages[0].freed = VT_NEVER;
    struct channel_use u = channel_use_make(&t, (struct time_bins){0, 1000, 2});
    double held = 0, share;
    for (uint32_t c = 0; c < u.channels; c++) {
        struct topo_channel ends = topo_channel(&t.topo, c);
        bool on_path = (ends.kind == TOPO_IN && ends.from == 0) ||
                       (ends.kind == TOPO_OUT && ends.from == 3) ||
                       (ends.kind == TOPO_LINK && ends.from == 0 && ends.to == 1) ||
                       (ends.kind == TOPO_LINK && ends.from == 1 && ends.to == 3);
        assert_true(channel_use_share(&u, 0, c) == (on_path ? 0.5 : 0));
        assert_true(channel_use_share(&u, 1, c) == 0);
        held += channel_use_share(&u, 0, c);
    }
    assert_true(held == 2);
    struct topo_channel busiest = topo_channel(&t.topo, channel_use_busiest(&u, &share));
    assert_true(busiest.from == 0 || busiest.from == 1 || busiest.from == 3);
    assert_true(share == 0.25);
    channel_use_free(&u);
    drop(&t);
}

/* How many links a mesh has that lead somewhere. */
static uint32_t real_links(const struct topo *t)
{
    uint32_t count = 0;
    for (uint32_t c = 0; c < t->channels; c++)
        count += channel_is_real(t, c) && topo_channel(t, c).kind == TOPO_LINK;
    return count;
}

static void channels_over_the_edge_are_none(void **state)
{
    (void)state;
    struct topo t;
    assert_true(topo_mesh(&t, 12, 3, 4));
    assert_int_equal(real_links(&t), 2 * (3 * 3 + 4 * 2));
    assert_true(topo_mesh(
        &t, 9, 3, 3)); /* its corner's south channel has the number that a service's link could have */
    topo_add_services(&t, 5);
    assert_int_equal(real_links(&t), 2 * (3 * 4 + 5 * 2)); /* 3 x 5 routers: one of them empty */
    assert_int_equal(mesh_spot_of(&t, 10).column, 3);
    assert_int_equal(mesh_spot_of(&t, 10).row, 1);
    assert_int_equal(mesh_spot_of(&t, 5).column, 2);
    assert_int_equal(mesh_spot_of(&t, 5).row, 1);
    assert_true(topo_hypercube(&t, 8, 3));
    assert_int_equal(real_links(&t), 24);
}

/* --- scales and texts --- */

static void scales_are_round(void **state)
{
    (void)state;
    assert_true(axis_step(100, 5) == 20);
    assert_true(axis_step(101, 5) == 50);
    assert_true(axis_count_step(1, 5) == 1); /* half a message was a tick */
    assert_true(axis_count_step(101, 5) == 50);
    assert_true(axis_count_step(0.5, 5) == axis_step(0.5, 5));
    assert_true(fabs(axis_step(0.007, 7) - 0.001) < 1e-15);
    assert_true(axis_end(6) == 6);
    assert_true(axis_end(6.1) == 8);
    assert_true(axis_end(0) == 1);
    struct heat h = heat_scale(3, 100), far = heat_scale(3, 1000);
    assert_false(h.logarithmic);
    assert_true(far.logarithmic);
    assert_int_equal(heat_level(&h, 0), HEAT_NONE);
    assert_int_equal(heat_level(&h, 100), PALETTE_LEVELS - 1);
    assert_int_equal(heat_level(&h, 49.9), PALETTE_LEVELS / 2 - 1);
    assert_int_equal(heat_level(&far, 1), 0);
    assert_int_equal(heat_level(&far, 1000), PALETTE_LEVELS - 1);
    struct heat given = heat_given(0.1, false), counts = heat_given(1000, true);
    assert_int_equal(heat_level(&given, 0.049), PALETTE_LEVELS / 2 - 1);
    assert_int_equal(heat_level(&counts, 1), 0);
    assert_text("10 % or more", heat_label(&given, 0.1, HEAT_PERCENT));
    assert_text("5 %", heat_label(&given, 0.05, HEAT_PERCENT));
    assert_text("100", heat_label(&h, 100, HEAT_NUMBER));
    assert_int_equal(heat_level(&counts, 5000), PALETTE_LEVELS - 1);
}

static void texts_are_for_people(void **state)
{
    (void)state;
    assert_text("0", axis_time_text(0, 1));
    assert_text("1.5 ms", axis_time_text(1500 * VT_MICROSECOND, VT_MICROSECOND));
    assert_text("107.2 s", axis_time_text(107 * VT_SECOND + 223 * VT_MILLISECOND, VT_SECOND / 10));
    assert_text("40 \u00b5s", axis_time_text(40 * VT_MICROSECOND, VT_MICROSECOND));
    assert_text("7 ps", axis_time_text(7, 1));
    assert_text("999", axis_number_text(999, false));
    assert_text("1.5 k", axis_number_text(1500, false));
    assert_text("59.3 MB", axis_number_text(59.3e6, true));
    assert_text("20 B", axis_number_text(20, true));
    assert_text("27.8 %", axis_percent_text(0.278));
    assert_text("0.037 %", axis_percent_text(0.000371));
    assert_text("< 0.001 %", axis_percent_text(1e-9));
    assert_text("0 %", axis_percent_text(0));
}

/* CIE lightness, 0 to 100: what is left of a colour in grey print. */
static double lightness(struct colour c)
{
    const double parts[] = {c.r, c.g, c.b}, weights[] = {0.2126, 0.7152, 0.0722};
    double y = 0;
    for (int i = 0; i < 3; i++)
        y += weights[i] * (parts[i] <= 0.04045 ? parts[i] / 12.92 : pow((parts[i] + 0.055) / 1.055, 2.4));
    return y > 0.008856 ? 116 * cbrt(y) - 16 : 903.3 * y;
}

static void colours_survive_grey_print(void **state)
{
    (void)state;
    for (enum activity a = 0; a <= ACTIVITIES; a++)
        for (enum activity b = 0; b < a; b++)
            assert_true(fabs(lightness(palette_activity(a)) - lightness(palette_activity(b))) >
                        (a == ACTIVITIES ? 7 : 10));
    for (int level = 1; level < PALETTE_LEVELS; level++)
        assert_true(lightness(palette_level(level)) < lightness(palette_level(level - 1)));
}

/* --- pictures --- */

struct drawing {
    const struct display *display;
    const struct show *show;
};

static void draw(void *ctx, const struct canvas *c)
{
    const struct drawing *d = ctx;
    d->display->draw(d->show, c);
}

/* How many pixels of a picture, above its legend or in it, have the colour. */
static double pixels_in(const char *path, struct colour c, bool legend)
{
    cairo_surface_t *png = cairo_image_surface_create_from_png(path);
    assert_int_equal(cairo_surface_status(png), CAIRO_STATUS_SUCCESS);
    uint32_t wanted =
        (uint32_t)lround(c.r * 255) << 16 | (uint32_t)lround(c.g * 255) << 8 | (uint32_t)lround(c.b * 255);
    int width = cairo_image_surface_get_width(png), height = cairo_image_surface_get_height(png);
    const unsigned char *data = cairo_image_surface_get_data(png);
    double count = 0;
    for (int y = legend ? height - 80 : 0; y < (legend ? height : height - 80); y++) {
        const uint32_t *row = (const void *)(data + (size_t)y * (size_t)cairo_image_surface_get_stride(png));
        for (int x = 0; x < width; x++)
            count += (row[x] & 0xffffff) == wanted;
    }
    cairo_surface_destroy(png);
    return count;
}

static double pixels_of(const char *path, struct colour c)
{
    return pixels_in(path, c, false);
}

/* In an interval, or on so many nodes, that their share was nothing, handlers were not in the legend. */
static void handlers_are_in_every_legend(void **state)
{
    (void)state;
    struct trace t = two_nodes();
    struct show s = {.trace = &t, .rows = node_rows_make(&t)};
    struct drawing d = {display_find("gantt"), &s};
    char path[] = "/tmp/test_show.XXXXXX", *error = NULL;
    close(mkstemp(path));
    assert_true(picture_write(path, PICTURE_PNG, d.display->height(&s), draw, &d, &error));
    assert_true(pixels_in(path, palette_activity(ACTIVITY_HANDLER), true) > 100);
    assert_true(pixels_of(path, palette_activity(ACTIVITY_HANDLER)) == 0);
    unlink(path);
    node_rows_free(&s.rows);
    drop(&t);
}

/* A network of which a channel was held 1 % of the time is pale, unless the scale is to end there; a matrix's
 * scale, too, can be given. */
static void scales_can_be_given(void **state)
{
    (void)state;
    struct trace t = made_trace(2, VT_SECOND);
    int32_t send = made_call(&t, 0, "csend", TRACE_SENDS, 1, 0, 10);
    int32_t receive = made_call(&t, 1, "crecv", TRACE_RECEIVES, 1, 0, VT_SECOND);
    made_message(&t, send, receive, 1, 1, 10, 10, VT_SECOND / 100, VT_SECOND / 100);
    char path[] = "/tmp/test_show.XXXXXX", *error = NULL;
    close(mkstemp(path));
    static const char *const NAMES[] = {"channels", "matrix"};
    for (size_t i = 0; i < 2; i++) {
        double dark[2];
        for (int k = 0; k < 2; k++) {
            struct show s = {.trace = &t, .rows = node_rows_make(&t)};
            s.most_share = k ? 0.01 : 0;   /* the channel's share */
            s.most_amount = k ? 0 : 10000; /* of one message */
            struct drawing d = {display_find(NAMES[i]), &s};
            assert_true(picture_write(path, PICTURE_PNG, d.display->height(&s), draw, &d, &error));
            dark[k] = pixels_of(path, palette_level(PALETTE_LEVELS - 1));
            node_rows_free(&s.rows);
        }
        assert_true(dark[1] > 1.2 * dark[0]); /* both have the scale's bar */
    }
    unlink(path);
    drop(&t);
}

/* The space-time diagram's pixels of a colour. */
static double space_time_pixels(const struct trace *t, bool densest, struct colour c)
{
    struct show s = {.trace = t, .rows = node_rows_make(t), .densest = densest};
    struct drawing d = {display_find("space-time"), &s};
    char path[] = "/tmp/test_show.XXXXXX", *error = NULL;
    close(mkstemp(path));
    assert_true(picture_write(path, PICTURE_PNG, d.display->height(&s), draw, &d, &error));
    double pixels = pixels_of(path, c);
    unlink(path);
    node_rows_free(&s.rows);
    return pixels;
}

/* 300 messages within 1 ms of a second's 600 were one line. */
static void space_time_opens_where_messages_are_dense(void **state)
{
    (void)state;
    struct trace t = made_trace(2, VT_SECOND);
    double black[2];
    for (int i = 0; i < 450; i++) {
        vtime sent =
            i < 40 ? (vtime)i * VT_SECOND / 50 : VT_SECOND * 9 / 10 + (vtime)(i - 40) * VT_MICROSECOND;
        int32_t send = made_call(&t, 0, "csend", TRACE_SENDS, 1, sent, sent + 10);
        int32_t receive = made_call(&t, 1, "crecv", TRACE_RECEIVES, 1, sent, sent + VT_MICROSECOND);
        made_message(&t, send, receive, 1, 1, sent, sent, sent + 100, sent + VT_MICROSECOND);
    }
    for (int densest = 0; densest < 2; densest++)
        black[densest] = space_time_pixels(&t, densest, COLOUR(0x222222));
    assert_true(black[1] > 2 * black[0]);
    drop(&t);
}

/* A few messages at the end of a run were one line, though all had room. */
static void space_time_opens_where_few_messages_are(void **state)
{
    (void)state;
    struct trace t = made_trace(2, VT_SECOND);
    double black[2];
    for (int i = 0; i < 8; i++) {
        vtime sent = VT_SECOND * 9 / 10 + (vtime)i * VT_MICROSECOND;
        int32_t send = made_call(&t, 0, "csend", TRACE_SENDS, 1, sent, sent + 10);
        int32_t receive = made_call(&t, 1, "crecv", TRACE_RECEIVES, 1, sent, sent + VT_MICROSECOND);
        made_message(&t, send, receive, 1, 1, sent, sent, sent + 100, sent + VT_MICROSECOND);
    }
    for (int densest = 0; densest < 2; densest++)
        black[densest] = space_time_pixels(&t, densest, COLOUR(0x222222));
    assert_true(black[1] > 3 * black[0]);
    drop(&t);
}

/* All sent at one moment: the picture had two picoseconds around that, and no line left the sender's. */
static void space_time_has_arrivals_of_messages_sent_at_once(void **state)
{
    (void)state;
    struct trace t = made_trace(9, VT_SECOND);
    vtime sent = VT_SECOND / 2, later = sent + VT_MILLISECOND;
    for (int i = 0; i < 450; i++) {
        int32_t send = made_call(&t, 0, "csend", TRACE_SENDS, 1, sent, sent + 10);
        int32_t receive = made_call(&t, 1 + i % 8, "crecv", TRACE_RECEIVES, 1, later, later + 10);
        made_message(&t, send, receive, 1, 1, sent, sent, sent + 100, sent + VT_MICROSECOND);
    }
    assert_true(space_time_pixels(&t, true, COLOUR(0xd97706)) >
                0.75 * (CANVAS_WIDTH - LEFT - 24) * CANVAS_PIXELS);
    drop(&t);
}

static void a_long_message_crosses_a_short_interval(void **state)
{
    (void)state;
    struct trace t = made_trace(2, VT_SECOND);
    int32_t send = made_call(&t, 0, "csend", TRACE_SENDS, 1, 0, 10);
    int32_t receive = made_call(&t, 1, "crecv", TRACE_RECEIVES, 1, 0, VT_SECOND);
    made_message(&t, send, receive, 1, 1, 10, 10, VT_SECOND - 1, VT_SECOND);
    t.from = VT_SECOND / 2, t.to = t.from + 100;
    assert_true(space_time_pixels(&t, false, COLOUR(0x222222)) >
                0.9 * (CANVAS_WIDTH - LEFT - 24) * CANVAS_PIXELS);
    drop(&t);
}

static void areas_are_shares_of_time(void **state)
{
    (void)state;
    static const char *const NAMES[] = {"utilisation", "gantt"};
    struct trace t = two_nodes(); /* computing 130 of 200, in a call 10, waiting 20 */
    struct show s = {.trace = &t, .rows = node_rows_make(&t), .frames = 1};
    char path[] = "/tmp/test_show.XXXXXX", *error = NULL;
    close(mkstemp(path));
    for (size_t i = 0; i < 2; i++) {
        struct drawing d = {display_find(NAMES[i]), &s};
        assert_true(picture_write(path, PICTURE_PNG, d.display->height(&s), draw, &d, &error));
        double computing = pixels_of(path, palette_activity(ACTIVITY_COMPUTING)),
               call = pixels_of(path, palette_activity(ACTIVITY_CALL)),
               waiting = pixels_of(path, palette_activity(ACTIVITY_WAITING));
        if (i == 0) /* of the plot's pixels */
            assert_true(fabs(computing / ((CANVAS_WIDTH - LEFT - 24) * 2 * 400 * 2) - 130 / 200.0) < 0.005);
        assert_true(fabs(call / computing - 10 / 130.0) < 0.005);
        assert_true(fabs(waiting / computing - 20 / 130.0) < 0.005);
    }
    unlink(path);
    node_rows_free(&s.rows);
    drop(&t);
}

/* A text that is cut off touches the picture's left or right edge. */
static bool edges_are_white(const char *path)
{
    cairo_surface_t *png = cairo_image_surface_create_from_png(path);
    assert_int_equal(cairo_surface_status(png), CAIRO_STATUS_SUCCESS);
    int width = cairo_image_surface_get_width(png), height = cairo_image_surface_get_height(png);
    const unsigned char *data = cairo_image_surface_get_data(png);
    bool white = true;
    for (int y = 0; y < height; y++) {
        const uint32_t *row = (const void *)(data + (size_t)y * (size_t)cairo_image_surface_get_stride(png));
        white &= (row[0] & 0xffffff) == 0xffffff && (row[width - 1] & 0xffffff) == 0xffffff;
    }
    cairo_surface_destroy(png);
    return white;
}

/* The words below the channels of one node were cut off. */
static void every_display_draws_a_trace_of_nothing(void **state)
{
    (void)state;
    struct trace t = made_trace(1, 1);
    struct show s = {.trace = &t, .rows = node_rows_make(&t), .frames = 1};
    char path[] = "/tmp/test_show.XXXXXX", *error = NULL;
    close(mkstemp(path));
    for (const struct display *d = DISPLAYS; d->name; d++)
        for (int kind = PICTURE_PNG; !d->film && kind <= PICTURE_SVG; kind++) {
            struct drawing drawing = {d, &s};
            assert_true(picture_write(path, (enum picture_kind)kind, d->height(&s), draw, &drawing, &error));
            assert_true(kind != PICTURE_PNG || edges_are_white(path));
        }
    unlink(path);
    node_rows_free(&s.rows);
    drop(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bins_share_what_they_overlap),
        cmocka_unit_test(bins_of_days_do_not_overflow),
        cmocka_unit_test(few_nodes_have_a_row_each_many_share),
        cmocka_unit_test(classes_are_powers_of_two_and_the_host_is_apart),
        cmocka_unit_test(of_many_nodes_those_that_serve_have_a_row_each),
        cmocka_unit_test(rows_of_hosts_are_higher),
        cmocka_unit_test(activities_by_hand),
        cmocka_unit_test(a_handler_s_computing_is_told_apart),
        cmocka_unit_test(activities_by_brute_force),
        cmocka_unit_test(the_matrix_has_each_message_once),
        cmocka_unit_test(nodes_that_are_not_shown_are_others),
        cmocka_unit_test(lengths_are_classed_by_powers_of_two),
        cmocka_unit_test(queues_by_hand),
        cmocka_unit_test(a_message_taken_as_another_comes_is_gone),
        cmocka_unit_test(queues_by_brute_force),
        cmocka_unit_test(a_sample_is_even_and_always_the_same),
        cmocka_unit_test(channels_are_held_along_the_path),
        cmocka_unit_test(channels_over_the_edge_are_none),
        cmocka_unit_test(scales_are_round),
        cmocka_unit_test(texts_are_for_people),
        cmocka_unit_test(handlers_are_in_every_legend),
        cmocka_unit_test(scales_can_be_given),
        cmocka_unit_test(space_time_opens_where_messages_are_dense),
        cmocka_unit_test(space_time_opens_where_few_messages_are),
        cmocka_unit_test(space_time_has_arrivals_of_messages_sent_at_once),
        cmocka_unit_test(colours_survive_grey_print),
        cmocka_unit_test(areas_are_shares_of_time),
        cmocka_unit_test(a_long_message_crosses_a_short_interval),
        cmocka_unit_test(every_display_draws_a_trace_of_nothing),
    };
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    canvas_forget_fonts();
    return failed;
}
