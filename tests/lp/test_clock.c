/* A node's clock: units and time, deadlines, slice boundaries, lookahead, stolen time, roll back, crashes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "lp/block.h"
#include "lp/clock.h"
#include "tests/child.h"

enum { MHZ = 1000000, CLOCK = NXC_UNITS_PER_CLOCK };

/* 25 and 20 ps a unit; and 30.3..., which is no whole number. */
static const uint64_t HZ[] = {40 * MHZ, 50 * MHZ, 33 * MHZ};
enum { CLOCKS = sizeof HZ / sizeof HZ[0] };

/* A logical process that has no program but its two words. */
struct fake {
    struct schedule s;
    struct lp lp;
    int64_t budget, lookahead;
};

static struct lp *begin(struct fake *f, uint64_t hz)
{
    *f = (struct fake){.s = {.max_time = VT_NEVER}};
    lp_begin(&f->lp, &f->s, 0);
    lp_bind(&f->lp, &f->budget, &f->lookahead);
    clock_set(&f->lp, hz);
    clock_begin_segment(&f->lp);
    clock_allow(&f->lp, VT_NEVER);
    return &f->lp;
}

/* What nxcc's code does for a basic block. */
static void spend(struct fake *f, int64_t units)
{
    f->budget -= units;
}

/* nxc_preempt, at some place in the program. */
static void poll_at(struct fake *f, uintptr_t at)
{
    clock_sync(&f->lp);
    clock_take_lookahead(&f->lp);
    clock_reach_boundary(&f->lp, at);
    clock_allow(&f->lp, VT_NEVER);
}

/* --- units and time --- */

static void a_unit_takes_a_thousandth_of_a_clock(void **state)
{
    struct fake f;
    (void)state;
    assert_int_equal(clock_of_units(begin(&f, 40 * MHZ), 1), 25);
    assert_int_equal(clock_of_units(begin(&f, 50 * MHZ), 1), 20);
    for (int i = 0; i < CLOCKS; i++)
        assert_int_equal(clock_of_units(begin(&f, HZ[i]), HZ[i] * CLOCK), VT_SECOND);
}

static void where_a_unit_is_no_whole_number_of_ps_only_the_sum_is_rounded(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 33 * MHZ);
    (void)state;
    assert_int_equal(clock_of_units(lp, 1), 30);
    assert_int_equal(clock_of_units(lp, 2), 60);
    assert_int_equal(clock_of_units(lp, 3), 90);
    assert_int_equal(clock_of_units(lp, 4), 121);
    assert_int_equal(clock_of_units(lp, 33), 1000);
}

static void a_day_of_units_does_not_overflow(void **state)
{
    struct fake f;
    (void)state;
    for (int i = 0; i < CLOCKS; i++) {
        struct lp *lp = begin(&f, HZ[i]);
        assert_int_equal(clock_of_units(lp, 86400 * HZ[i] * CLOCK), 86400 * VT_SECOND);
        assert_int_equal(clock_units_in(lp, 86400 * VT_SECOND), 86400 * HZ[i] * CLOCK);
    }
}

static void the_units_in_a_time_are_the_least_that_take_it(void **state)
{
    struct fake f;
    (void)state;
    for (int i = 0; i < CLOCKS; i++) {
        struct lp *lp = begin(&f, HZ[i]);
        assert_int_equal(clock_units_in(lp, 0), 0);
        for (vtime t = 1; t < 3000; t++) {
            uint64_t units = clock_units_in(lp, t);
            assert_true(clock_of_units(lp, units) >= t);
            assert_true(clock_of_units(lp, units - 1) < t);
        }
    }
}

static void how_often_the_clock_is_synchronised_changes_no_time(void **state)
{
    struct fake often, once;
    (void)state;
    for (int i = 0; i < CLOCKS; i++) {
        begin(&often, HZ[i]), begin(&once, HZ[i]);
        for (int64_t n = 0; n < 1000; n++) {
            spend(&often, n % 7), spend(&once, n % 7);
            clock_sync(&often.lp);
            clock_sync(&often.lp);
        }
        assert_int_equal(clock_sync(&often.lp), clock_sync(&once.lp));
        assert_int_equal(often.lp.clock.units, once.lp.clock.units);
    }
}

static void a_program_in_a_call_spends_nothing(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    spend(&f, 10);
    assert_int_equal(clock_stop(lp), 250);
    spend(&f, 10);
    assert_int_equal(clock_sync(lp), 250);
    clock_advance(lp, 1000);
    clock_allow(lp, VT_NEVER);
    spend(&f, 1);
    assert_int_equal(clock_sync(lp), 1275);
}

static void go_back(void *arg)
{
    (void)arg;
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    spend(&f, 100);
    clock_advance_to(lp, 2499);
}

static void stay(void *arg)
{
    (void)arg;
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    spend(&f, 100);
    clock_advance_to(lp, 2500);
}

static void a_clock_set_back_is_caught(void **state)
{
    (void)state;
    assert_true(child_aborts(go_back, NULL));
    assert_false(child_aborts(stay, NULL));
}

/* --- deadlines --- */

static void the_first_poll_at_or_past_the_deadline_finds_the_budget_spent(void **state)
{
    struct fake f;
    (void)state;
    for (int i = 0; i < CLOCKS; i++)
        for (int64_t before = 0; before < 40; before++)
            for (vtime after = 1; after < 70; after++) {
                struct lp *lp = begin(&f, HZ[i]);
                spend(&f, before);
                vtime deadline = clock_stop(lp) + after;
                clock_allow(lp, deadline);
                spend(&f, f.budget);
                assert_true(f.budget >= 0 && clock_sync(lp) < deadline);
                spend(&f, 1);
                assert_true(f.budget < 0 && clock_sync(lp) >= deadline);
            }
}

static void behind_its_deadline_a_program_computes_one_unit_only(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    spend(&f, 1000);
    vtime now = clock_sync(lp);
    clock_allow(lp, now);
    assert_int_equal(f.budget, 0);
    clock_allow(lp, now - 1);
    assert_int_equal(f.budget, 0);
    clock_allow(lp, now + 26);
    assert_int_equal(f.budget, 1);
}

/* --- slices --- */

static void slices_begin_at_10000_clocks_and_double_up_to_320000(void **state)
{
    static const uint64_t ENDS[] = {10, 20, 40, 80, 160, 320, 640, 960, 1280, 1600};
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    for (size_t i = 0; i < sizeof ENDS / sizeof ENDS[0]; i++) {
        spend(&f, f.budget + 1);
        clock_sync(lp);
        assert_int_equal(clock_segment_units(lp), ENDS[i] * 1000 * CLOCK);
        poll_at(&f, 1);
    }
    lp_unbind(lp);
}

static void a_late_poll_does_not_move_the_slice_boundaries(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    spend(&f, 45000 * CLOCK);
    poll_at(&f, 1);
    spend(&f, f.budget + 1);
    clock_sync(lp);
    assert_int_equal(clock_segment_units(lp), 80000 * CLOCK);
    lp_unbind(lp);
}

static void neither_a_deadline_nor_longest_slice_moves_a_boundary(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    f.s.longest_slice = 100 * VT_MICROSECOND; /* 4000 clocks */
    uint64_t stops[] = {4000, 8000, 9000, 10000};
    clock_allow(lp, VT_NEVER);
    for (int i = 0; i < 4; i++) {
        spend(&f, f.budget + 1);
        vtime now = clock_sync(lp);
        assert_int_equal(clock_segment_units(lp), stops[i] * CLOCK);
        clock_reach_boundary(lp, 1);
        assert_int_equal(lp->places ? lp->places->count : 0, i == 3);
        clock_allow(lp, i == 1 ? now + 25 * VT_MICROSECOND : VT_NEVER);
    }
    lp_unbind(lp);
}

static void each_segment_begins_its_slices_anew(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    spend(&f, 123456);
    clock_stop(lp);
    clock_begin_segment(lp);
    clock_allow(lp, VT_NEVER);
    assert_int_equal(clock_segment_units(lp), 0);
    assert_int_equal(f.budget, 10000 * CLOCK - 1);
}

/* --- lookahead --- */

static void a_poll_states_the_lookahead_in_units_from_where_control_was_given(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    assert_int_equal(clock_lookahead(lp), 0);
    int64_t granted = f.budget;
    spend(&f, 100);
    clock_sync(lp);
    assert_int_equal(f.budget, granted - 100);
    f.lookahead = f.budget - 500;
    clock_take_lookahead(lp);
    assert_int_equal(clock_lookahead_units(lp), 500);
    assert_int_equal(clock_lookahead(lp), 600 * 25);
}

static void a_program_that_states_none_has_no_lookahead(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    spend(&f, 100);
    clock_sync(lp);
    clock_take_lookahead(lp);
    assert_int_equal(clock_lookahead_units(lp), 0);
    assert_int_equal(clock_lookahead(lp), 100 * 25);
}

static void the_lookahead_ends_at_the_slice_boundary(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    clock_set_lookahead(lp, 50000 * CLOCK);
    assert_int_equal(clock_lookahead(lp), 10000 * CLOCK * 25);
    assert_int_equal(clock_lookahead_units(lp), 50000 * CLOCK);
}

static void a_lookahead_once_stated_does_not_shrink(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    clock_set_lookahead(lp, 700);
    clock_set_lookahead(lp, 300);
    assert_int_equal(clock_lookahead_units(lp), 700);
    clock_begin_segment(lp);
    assert_int_equal(clock_lookahead_units(lp), 0);
}

static void a_call_within_the_lookahead_is_found(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    clock_set_lookahead(lp, 700);
    spend(&f, 699);
    clock_stop(lp);
    assert_true(clock_lookahead_is_broken(lp));
    clock_allow(lp, VT_NEVER);
    spend(&f, 1);
    clock_stop(lp);
    assert_false(clock_lookahead_is_broken(lp));
}

/* --- places --- */

static void the_last_place_is_that_of_the_latest_boundary(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    assert_int_equal(clock_last_place(lp), 0);
    spend(&f, 5000 * CLOCK);
    poll_at(&f, 0xa);
    assert_int_equal(clock_last_place(lp), 0);
    for (uintptr_t at = 1; at <= 3; at++) {
        spend(&f, f.budget + 1);
        poll_at(&f, at);
        assert_int_equal(clock_last_place(lp), at);
    }
    lp_unbind(lp);
}

static void after_a_roll_back_the_last_place_is_an_earlier_one(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    for (uintptr_t at = 1; at <= 3; at++)
        spend(&f, f.budget + 1), poll_at(&f, at);
    clock_roll_back(lp, 15000 * CLOCK * 25); /* from 40000 clocks to 25000 */
    assert_int_equal(clock_last_place(lp), 2);
    clock_note_committed(lp, 22000 * CLOCK);
    assert_int_equal(clock_last_place(lp), 0);
    lp_unbind(lp);
}

static void a_loop_is_known_by_equal_places_in_a_row(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    spend(&f, f.budget + 1), poll_at(&f, 1);
    vtime since = 0;
    for (int k = 1; k <= LP_LOOP + LP_PLACES; k++) { /* more than the ring holds */
        assert_true(clock_time_in_loop(lp) == (k <= LP_LOOP ? 0 : clock_sync(lp) - since));
        spend(&f, f.budget + 1), poll_at(&f, 2);
        since = k == 1 ? clock_sync(lp) : since;
    }
    clock_begin_segment(lp); /* after a handler, a row begins anew */
    clock_allow(lp, VT_NEVER);
    spend(&f, f.budget + 1), poll_at(&f, 2);
    assert_true(clock_time_in_loop(lp) == 0);
    lp_unbind(lp);
}

static void places_that_the_ring_has_lost_are_unknown(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    for (uintptr_t at = 1; at <= LP_PLACES + 2; at++)
        spend(&f, f.budget + 1), poll_at(&f, at);
    assert_int_equal(clock_last_place(lp), LP_PLACES + 2);
    clock_roll_back(lp, clock_sync(lp) - 25000 * CLOCK * 25);
    assert_int_equal(clock_last_place(lp), 0);
    lp_unbind(lp);
}

/* --- stolen time, roll back, crashes --- */

static void stolen_time_is_the_clocks_only_when_it_is_added(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    spend(&f, 4);
    clock_steal(lp, 30), clock_steal(lp, 12);
    assert_int_equal(clock_sync(lp), 100);
    assert_int_equal(clock_add_stolen(lp), 42);
    assert_int_equal(clock_add_stolen(lp), 0);
    assert_int_equal(clock_sync(lp), 142);
    clock_steal(lp, 30);
    clock_drop_stolen(lp);
    assert_int_equal(clock_add_stolen(lp), 0);
    assert_int_equal(lp->clock.units, 4);
}

static void after_a_roll_back_it_is_unknown_how_far_the_program_had_computed_ahead(void **state)
{
    struct fake near, far;
    (void)state;
    for (int i = 0; i < CLOCKS; i++)
        for (vtime back_to = 0; back_to < 2000; back_to += 13) {
            begin(&near, HZ[i]), begin(&far, HZ[i]);
            spend(&near, 100), spend(&far, 54321);
            clock_roll_back(&near.lp, clock_sync(&near.lp) - back_to);
            clock_roll_back(&far.lp, clock_sync(&far.lp) - back_to);
            assert_int_equal(near.lp.clock.units, far.lp.clock.units);
            assert_int_equal(near.lp.clock.now, far.lp.clock.now);
            assert_int_equal(near.lp.clock.units, clock_units_in(&near.lp, back_to));
        }
}

/* Many units of a fast processor end within one picosecond. */
static void a_program_that_is_ended_where_it_is_has_the_least_units_of_that_time(void **state)
{
    struct fake there, beyond;
    (void)state;
    struct lp *lp = begin(&there, 45000UL * MHZ), *ahead = begin(&beyond, 45000UL * MHZ);
    spend(&there, 92118000), spend(&beyond, 92999999);
    vtime t = clock_sync(lp);
    assert_true(clock_sync(ahead) > t);
    lp->state = ahead->state = LP_COMPUTING;
    assert_true(lp_end_at(lp, t) && lp_end_at(ahead, t));
    assert_int_equal(lp->clock.units, ahead->clock.units);
}

static void roll_back_takes_no_more_than_has_been_computed(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    clock_advance(lp, 1000); /* system time, which is not computing */
    spend(&f, 100);
    clock_roll_back(lp, 2600);
    assert_int_equal(clock_sync(lp), 1000);
    assert_int_equal(lp->clock.units, 0);
}

static void a_crash_is_counted_at_the_next_slice_boundary(void **state)
{
    struct fake f;
    (void)state;
    for (int64_t spent = 0; spent <= 9000 * CLOCK; spent += 3000 * CLOCK) {
        struct lp *lp = begin(&f, 40 * MHZ);
        spend(&f, spent / 2);
        clock_sync(lp);
        clock_allow(lp, clock_sync(lp) + VT_MICROSECOND);
        spend(&f, spent / 2);
        clock_crash(lp);
        assert_int_equal(lp->clock.units, 10000 * CLOCK);
        assert_int_equal(clock_sync(lp), 250 * VT_MICROSECOND);
    }
}

static void a_crash_of_a_program_that_wrote_over_its_count_has_a_time(void **state)
{
    static const uint64_t over[] = {UINT64_C(0x0101010101010101), UINT64_C(0x8080808080808080), 1ULL << 63};
    struct fake f;
    (void)state;
    for (int i = 0; i < 3; i++) {
        struct lp *lp = begin(&f, 40 * MHZ);
        spend(&f, 3000 * CLOCK);
        clock_sync(lp);
        f.budget = (int64_t)over[i];
        clock_doubt(lp);
        clock_sync(lp);
        clock_crash(lp);
        assert_int_equal(clock_sync(lp), 250 * VT_MICROSECOND);
    }
}

static void boundaries_are_passed_at_once(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    spend(&f, INT64_C(1) << 58);
    poll_at(&f, 1);
    assert_true(lp->segment.end > lp->clock.units);
    assert_true(lp->segment.end - lp->clock.units <= 320000 * CLOCK);
    lp_unbind(lp);
}

static void the_time_of_units_to_come_counts_from_now(void **state)
{
    struct fake f;
    struct lp *lp = begin(&f, 40 * MHZ);
    (void)state;
    spend(&f, 100);
    clock_sync(lp);
    clock_advance(lp, 7);
    assert_int_equal(clock_when(lp, 101), 2500 + 7 + 25);
    assert_int_equal(clock_when(lp, 100), 0);
    clock_return_to(lp, 50, 1250);
    assert_int_equal(clock_when(lp, 100), 2500);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_unit_takes_a_thousandth_of_a_clock),
        cmocka_unit_test(where_a_unit_is_no_whole_number_of_ps_only_the_sum_is_rounded),
        cmocka_unit_test(a_day_of_units_does_not_overflow),
        cmocka_unit_test(the_units_in_a_time_are_the_least_that_take_it),
        cmocka_unit_test(how_often_the_clock_is_synchronised_changes_no_time),
        cmocka_unit_test(a_program_in_a_call_spends_nothing),
        cmocka_unit_test(a_clock_set_back_is_caught),
        cmocka_unit_test(the_first_poll_at_or_past_the_deadline_finds_the_budget_spent),
        cmocka_unit_test(behind_its_deadline_a_program_computes_one_unit_only),
        cmocka_unit_test(slices_begin_at_10000_clocks_and_double_up_to_320000),
        cmocka_unit_test(a_late_poll_does_not_move_the_slice_boundaries),
        cmocka_unit_test(neither_a_deadline_nor_longest_slice_moves_a_boundary),
        cmocka_unit_test(each_segment_begins_its_slices_anew),
        cmocka_unit_test(a_poll_states_the_lookahead_in_units_from_where_control_was_given),
        cmocka_unit_test(a_program_that_states_none_has_no_lookahead),
        cmocka_unit_test(the_lookahead_ends_at_the_slice_boundary),
        cmocka_unit_test(a_lookahead_once_stated_does_not_shrink),
        cmocka_unit_test(a_call_within_the_lookahead_is_found),
        cmocka_unit_test(the_last_place_is_that_of_the_latest_boundary),
        cmocka_unit_test(after_a_roll_back_the_last_place_is_an_earlier_one),
        cmocka_unit_test(a_loop_is_known_by_equal_places_in_a_row),
        cmocka_unit_test(places_that_the_ring_has_lost_are_unknown),
        cmocka_unit_test(stolen_time_is_the_clocks_only_when_it_is_added),
        cmocka_unit_test(after_a_roll_back_it_is_unknown_how_far_the_program_had_computed_ahead),
        cmocka_unit_test(a_program_that_is_ended_where_it_is_has_the_least_units_of_that_time),
        cmocka_unit_test(roll_back_takes_no_more_than_has_been_computed),
        cmocka_unit_test(a_crash_is_counted_at_the_next_slice_boundary),
        cmocka_unit_test(a_crash_of_a_program_that_wrote_over_its_count_has_a_time),
        cmocka_unit_test(boundaries_are_passed_at_once),
        cmocka_unit_test(the_time_of_units_to_come_counts_from_now),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
