/* The order of events: (time, place, late, sequence), whatever the order they were put in. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "kernel/evq.h"

struct log {
    int seen[4096];
    vtime at[4096];
    int count;
};

static void note(void *ctx, void *arg, vtime now)
{
    struct log *log = ctx;
    log->at[log->count] = now;
    log->seen[log->count++] = (int)(intptr_t)arg;
}

static void run(struct evq *q)
{
    while (evq_step(q))
        ;
    evq_free(q);
}

static void put(struct evq *q, struct log *log, vtime t, uint32_t place, int id)
{
    evq_put(q, t, place, note, log, (void *)(intptr_t)id);
}

static void earlier_time_comes_first(void **state)
{
    struct log log = {0};
    struct evq *q = evq_new();
    (void)state;
    put(q, &log, 30, 0, 3);
    put(q, &log, 10, 9, 1);
    put(q, &log, 20, 0, 2);
    assert_int_equal(evq_next(q), 10);
    run(q);
    for (int i = 0; i < 3; i++)
        assert_int_equal(log.seen[i], i + 1);
}

static void at_one_time_places_go_in_order_and_at_one_place_sequence_decides(void **state)
{
    struct log log = {0};
    struct evq *q = evq_new();
    (void)state;
    put(q, &log, 5, 2, 3);
    put(q, &log, 5, 1, 1);
    put(q, &log, 5, 2, 4);
    put(q, &log, 5, 1, 2);
    run(q);
    for (int i = 0; i < 4; i++)
        assert_int_equal(log.seen[i], i + 1);
}

static void late_events_come_after_all_others_of_their_time_and_place(void **state)
{
    struct log log = {0};
    struct evq *q = evq_new();
    (void)state;
    evq_put_late(q, 5, 1, note, &log, (void *)2);
    put(q, &log, 5, 1, 1);
    put(q, &log, 5, 2, 3);
    assert_false(evq_late_is_first(q, 5, 1));
    assert_true(evq_late_is_first(q, 5, 0));
    assert_true(evq_late_is_first(q, 4, 7));
    run(q);
    for (int i = 0; i < 3; i++)
        assert_int_equal(log.seen[i], i + 1);
}

static void thousands_of_events_come_out_sorted(void **state)
{
    struct log log = {0};
    struct evq *q = evq_new();
    uint32_t x = 12345;
    (void)state;
    for (int i = 0; i < 4000; i++) {
        x = x * 1664525u + 1013904223u;
        put(q, &log, x >> 20, x & 7, i);
    }
    assert_int_equal(evq_length(q), 4000);
    run(q);
    assert_int_equal(log.count, 4000);
    for (int i = 1; i < 4000; i++)
        assert_true(log.at[i - 1] <= log.at[i]);
}

static void count(void *ctx, void *arg, vtime now)
{
    (void)arg, (void)now;
    ++*(int *)ctx;
}

static void other(void *ctx, void *arg, vtime now)
{
    (void)ctx, (void)arg, (void)now;
}

static void what_comes_is_known_two_events_ahead(void **state)
{
    enum { EVENTS = 100 };
    int happened[EVENTS] = {0};
    struct evq *q = evq_new();
    (void)state;
    assert_null(evq_coming(q, 0, count));
    for (int i = 0; i < EVENTS; i++) {
        int at = i * 37 % EVENTS;
        evq_put(q, (vtime)at, 0, count, &happened[at], NULL);
    }
    for (int at = 0; at < EVENTS; at++) {
        assert_ptr_equal(evq_coming(q, 0, count), &happened[at]);
        assert_ptr_equal(evq_coming(q, 1, count), at + 1 < EVENTS ? &happened[at + 1] : NULL);
        assert_null(evq_coming(q, 0, other));
        assert_true(evq_step(q));
        assert_int_equal(happened[at], 1);
    }
    assert_null(evq_coming(q, 0, count));
    evq_free(q);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(earlier_time_comes_first),
        cmocka_unit_test(at_one_time_places_go_in_order_and_at_one_place_sequence_decides),
        cmocka_unit_test(late_events_come_after_all_others_of_their_time_and_place),
        cmocka_unit_test(thousands_of_events_come_out_sorted),
        cmocka_unit_test(what_comes_is_known_two_events_ahead),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
