/* I/O modes: which part of the file each call reads or writes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "cfs/modes.h"

static void one_pointer_goes_on_by_each_call(void **state)
{
    struct modes m = {0};
    struct modes_group *g = &m.group[MODE_FIRST_COME];
    (void)state;
    modes_join(&m, MODE_FIRST_COME, 100);
    modes_join(&m, MODE_FIRST_COME, 555); /* the first member's position holds */
    assert_int_equal(modes_take(g, 10), 100);
    assert_int_equal(modes_take(g, 5), 110);
    assert_int_equal(modes_take(g, 0), 115);
    modes_free(&m);
}

static void a_group_starts_anew_when_all_have_left(void **state)
{
    struct modes m = {0};
    struct modes_group *g = &m.group[MODE_ORDERED];
    (void)state;
    modes_join(&m, MODE_ORDERED, 0);
    modes_take(g, 10);
    modes_next_turn(g, 3);
    modes_leave(&m, MODE_ORDERED);
    modes_join(&m, MODE_ORDERED, 70);
    assert_int_equal(g->turn, 0);
    assert_int_equal(modes_take(g, 1), 70);
    modes_free(&m);
}

static void turns_go_round(void **state)
{
    struct modes m = {0};
    struct modes_group *g = &m.group[MODE_ORDERED];
    (void)state;
    modes_join(&m, MODE_ORDERED, 0);
    for (uint32_t i = 0; i < 7; i++) {
        assert_int_equal(g->turn, i % 3);
        modes_next_turn(g, 3);
    }
    modes_free(&m);
}

static uint64_t start_of(struct modes_group *g, uint64_t round, uint32_t nodes, uint64_t bytes)
{
    struct modes_round r = modes_record(g, round, nodes, NULL, bytes);
    assert_true(r.begun);
    return r.start;
}

static void rounds_follow_each_other(void **state)
{
    struct modes m = {0};
    struct modes_group *g = &m.group[MODE_RECORDS];
    (void)state;
    modes_join(&m, MODE_RECORDS, 1000);
    assert_int_equal(start_of(g, 0, 3, 50), 1000);
    assert_int_equal(start_of(g, 1, 3, 7), 1000 + 3 * 50); /* ahead of the others */
    assert_int_equal(start_of(g, 0, 3, 50), 1000);
    assert_int_equal(modes_round_from(g, 2, 3), 1000 + 3 * 57);
    modes_free(&m);
}

static void a_round_has_one_length(void **state)
{
    struct modes m = {0};
    struct modes_group *g = &m.group[MODE_RECORDS];
    (void)state;
    modes_join(&m, MODE_RECORDS, 0);
    assert_int_equal(modes_record(g, 0, 2, NULL, 50).bytes, 50);
    assert_int_equal(modes_record(g, 0, 2, NULL, 49).bytes, 50);
    modes_free(&m);
}

static void records_may_be_moved_before_a_round_begins(void **state)
{
    struct modes m = {0};
    struct modes_group *g = &m.group[MODE_RECORDS];
    const uint64_t late = 600;
    (void)state;
    modes_join(&m, MODE_RECORDS, 0);
    modes_set_round(g, 0, 2, 500);
    assert_int_equal(modes_round_from(g, 0, 2), 0); /* for a node that has yet to seek from here */
    assert_int_equal(start_of(g, 0, 2, 50), 500);
    modes_set_round(g, 0, 2, late);
    assert_int_equal(modes_record(g, 0, 2, &late, 50).start, 500);
    assert_int_equal(modes_round_from(g, 1, 2), 600);
    assert_int_equal(modes_record(g, 1, 2, &late, 50).start, 600);
    modes_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_pointer_goes_on_by_each_call),
        cmocka_unit_test(a_group_starts_anew_when_all_have_left),
        cmocka_unit_test(turns_go_round),
        cmocka_unit_test(rounds_follow_each_other),
        cmocka_unit_test(a_round_has_one_length),
        cmocka_unit_test(records_may_be_moved_before_a_round_begins),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
