/* Vector clocks: what is heard stays heard, shared clocks do not change, and nothing is made where nothing is
 * new. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include "races/race_clock.h"

static void nothing_is_heard_at_first(void **state)
{
    (void)state;
    assert_int_equal(race_clock_of(NULL, 3).main, 0);
    assert_true(race_clock_includes(NULL, NULL));
}

static void what_is_heard_stays(void **state)
{
    (void)state;
    struct race_clock *c = NULL;
    race_clock_hear(&c, 3, (struct race_known){5, 2});
    race_clock_hear(&c, 3, (struct race_known){4, 7});
    race_clock_hear(&c, 0, (struct race_known){1, 0});
    assert_int_equal(race_clock_of(c, 3).main, 5);
    assert_int_equal(race_clock_of(c, 3).handlers, 7);
    assert_int_equal(race_clock_of(c, 0).main, 1);
    assert_int_equal(race_clock_of(c, 1000).main, 0);
    race_clock_free(c);
}

static void a_shared_clock_does_not_change(void **state)
{
    (void)state;
    struct race_clock *c = NULL;
    race_clock_hear(&c, 1, (struct race_known){5, 0});
    struct race_clock *sent = race_clock_share(c);
    race_clock_hear(&c, 1, (struct race_known){6, 0});
    assert_ptr_not_equal(c, sent);
    assert_int_equal(race_clock_of(sent, 1).main, 5);
    assert_int_equal(race_clock_of(c, 1).main, 6);
    race_clock_free(sent);
    race_clock_free(c);
}

static void joining_makes_nothing_where_nothing_is_new(void **state)
{
    (void)state;
    struct race_clock *a = NULL, *b = NULL;
    race_clock_hear(&a, 1, (struct race_known){5, 5});
    race_clock_hear(&b, 1, (struct race_known){4, 5});
    struct race_clock *before = a, *shared = race_clock_share(a);
    race_clock_join(&a, b);
    assert_ptr_equal(a, before);
    assert_true(race_clock_includes(a, b));
    assert_false(race_clock_includes(b, a));
    race_clock_join(&b, a);
    assert_int_equal(race_clock_of(b, 1).main, 5);
    race_clock_free(shared);
    race_clock_free(a);
    race_clock_free(b);
}

static void joining_a_longer_clock_hears_of_its_nodes(void **state)
{
    (void)state;
    struct race_clock *a = NULL, *b = NULL;
    race_clock_hear(&a, 0, (struct race_known){9, 0});
    race_clock_hear(&b, 7, (struct race_known){3, 1});
    race_clock_join(&a, b);
    assert_int_equal(race_clock_of(a, 0).main, 9);
    assert_int_equal(race_clock_of(a, 7).handlers, 1);
    assert_false(race_clock_includes(b, a));
    race_clock_free(a);
    race_clock_free(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_heard_at_first),
        cmocka_unit_test(what_is_heard_stays),
        cmocka_unit_test(a_shared_clock_does_not_change),
        cmocka_unit_test(joining_makes_nothing_where_nothing_is_new),
        cmocka_unit_test(joining_a_longer_clock_hears_of_its_nodes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
