/* Buffers under way: which an access meets, and the gap by which most accesses are told to meet none. And
 * what is found: each pair of places once, whichever came first. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>
#include "races/race_findings.h"
#include "races/race_flights.h"

static const int KEYS[4];

static struct race_flight flight(int key, uintptr_t begin, uintptr_t end, bool receives)
{
    return (struct race_flight){.key = &KEYS[key], .begin = begin, .end = end, .receives = receives};
}

static bool meets(const struct race_flights *f, uintptr_t begin, uintptr_t end, bool write)
{
    uint32_t from = 0;
    return race_flights_next(f, begin, end, write, &from);
}

static void a_send_is_met_by_writes_only(void **state)
{
    (void)state;
    struct race_flights f = {0};
    struct race_flight send = flight(0, 100, 200, false), receive = flight(1, 300, 400, true);
    race_flights_add(&f, &send);
    race_flights_add(&f, &receive);
    assert_false(meets(&f, 100, 104, false));
    assert_true(meets(&f, 100, 104, true));
    assert_true(meets(&f, 399, 403, false));
    assert_false(meets(&f, 200, 300, true));
    race_flights_end(&f);
}

static void a_buffer_that_has_landed_is_met_no_more(void **state)
{
    (void)state;
    struct race_flights f = {0};
    struct race_flight a = flight(0, 100, 200, true), b = flight(1, 150, 250, true), out;
    race_flights_add(&f, &a);
    race_flights_add(&f, &b);
    assert_true(race_flights_remove(&f, &KEYS[0], &out));
    assert_int_equal(out.end, 200);
    assert_false(race_flights_remove(&f, &KEYS[0], &out));
    assert_false(meets(&f, 100, 150, true));
    assert_true(meets(&f, 100, 151, true));
    race_flights_end(&f);
}

static void an_empty_buffer_is_met_by_nothing(void **state)
{
    (void)state;
    struct race_flights f = {0};
    struct race_flight empty = flight(0, 100, 100, true);
    race_flights_add(&f, &empty);
    assert_false(meets(&f, 96, 104, true));
    race_flights_end(&f);
}

static void the_gap_has_no_buffer(void **state)
{
    (void)state;
    struct race_flights f = {0};
    struct race_flight a = flight(0, 100, 200, true), b = flight(1, 300, 400, false);
    race_flights_add(&f, &a);
    race_flights_add(&f, &b);
    assert_false(race_flights_miss(&f, 210, 214)); /* not known yet */
    race_flights_find_gap(&f, 210, 214);
    assert_true(race_flights_miss(&f, 200, 300));
    assert_false(race_flights_miss(&f, 199, 204));
    assert_false(race_flights_miss(&f, 299, 301));
    race_flights_find_gap(&f, 150, 154); /* meets a buffer: the gap stays */
    assert_true(race_flights_miss(&f, 200, 300));
    struct race_flight c = flight(2, 220, 230, true);
    race_flights_add(&f, &c);
    assert_false(race_flights_miss(&f, 210, 214));
    race_flights_end(&f);
}

static void a_pair_of_places_is_kept_once(void **state)
{
    (void)state;
    struct race_findings t = {0};
    struct race_finding f = {.what = RACE_OF_ACCESSES, .earlier.place = 3, .later.place = 9, .earlier.at = 5};
    struct race_finding turned = f;
    turned.earlier.place = 9, turned.later.place = 3, turned.earlier.at = 6;
    race_findings_add(&t, &f);
    race_findings_add(&t, &turned);
    turned.what = RACE_OF_UPDATE;
    race_findings_add(&t, &turned);
    assert_int_equal(t.count, 3);
    assert_int_equal(t.list[1].count, 2);
    assert_int_equal(t.list[1].earlier.at, 5);
    assert_int_equal(t.list[2].count, 1);
    race_findings_end(&t);
}

static void of_a_place_that_found_no_room_nothing_is_told(void **state)
{
    (void)state;
    struct race_findings t = {0};
    struct race_finding f = {.what = RACE_ON_SEND, .earlier = {.place = 0}, .later = {.place = 7}};
    race_findings_add(&t, &f);
    assert_int_equal(t.count, 1);
    assert_int_equal(t.dropped, 1);
    race_findings_end(&t);
}

static void findings_are_bounded(void **state)
{
    (void)state;
    struct race_findings t = {0};
    for (uint32_t i = 1; i < RACE_MOST_FINDINGS + 10; i++) {
        struct race_finding f = {.earlier.place = i, .later.place = i + 1};
        race_findings_add(&t, &f);
    }
    assert_int_equal(t.count, RACE_MOST_FINDINGS);
    assert_int_equal(t.dropped, 10);
    race_findings_end(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_send_is_met_by_writes_only),
        cmocka_unit_test(a_buffer_that_has_landed_is_met_no_more),
        cmocka_unit_test(an_empty_buffer_is_met_by_nothing),
        cmocka_unit_test(the_gap_has_no_buffer),
        cmocka_unit_test(a_pair_of_places_is_kept_once),
        cmocka_unit_test(of_a_place_that_found_no_room_nothing_is_told),
        cmocka_unit_test(findings_are_bounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
