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

static void records_lie_in_node_order_whoever_comes_first(void **state)
{
    struct modes m = {0};
    struct modes_group *g = &m.group[MODE_RECORDS];
    uint64_t at, others;
    (void)state;
    modes_join(&m, MODE_RECORDS, 1000);
    assert_true(modes_record(g, 0, 2, 3, 50, &at, &others));
    assert_int_equal(at, 1100);
    assert_true(modes_record(g, 1, 2, 3, 7, &at, &others)); /* ahead of the others */
    assert_int_equal(at, 1000 + 3 * 50 + 2 * 7);
    assert_true(modes_record(g, 0, 0, 3, 50, &at, &others));
    assert_int_equal(at, 1000);
    modes_free(&m);
}

static void a_round_has_one_length(void **state)
{
    struct modes m = {0};
    struct modes_group *g = &m.group[MODE_RECORDS];
    uint64_t at, others;
    (void)state;
    modes_join(&m, MODE_RECORDS, 0);
    assert_true(modes_record(g, 0, 1, 2, 50, &at, &others));
    assert_false(modes_record(g, 0, 0, 2, 49, &at, &others));
    assert_int_equal(others, 50);
    modes_free(&m);
}

static void records_may_be_moved_before_a_round_begins(void **state)
{
    struct modes m = {0};
    struct modes_group *g = &m.group[MODE_RECORDS];
    uint64_t at, others;
    (void)state;
    modes_join(&m, MODE_RECORDS, 0);
    for (uint32_t node = 0; node < 2; node++)
        assert_true(modes_set_round(g, 0, 2, 500));
    assert_true(modes_record(g, 0, 1, 2, 50, &at, &others));
    assert_int_equal(at, 550);
    assert_true(modes_set_round(g, 0, 2, 500)); /* a late node that wants the same */
    assert_false(modes_set_round(g, 0, 2, 600));
    assert_int_equal(modes_round_start(g, 1, 2), 600);
    modes_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_pointer_goes_on_by_each_call),
        cmocka_unit_test(a_group_starts_anew_when_all_have_left),
        cmocka_unit_test(turns_go_round),
        cmocka_unit_test(records_lie_in_node_order_whoever_comes_first),
        cmocka_unit_test(a_round_has_one_length),
        cmocka_unit_test(records_may_be_moved_before_a_round_begins),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
