/* The least of many times by address: after any changes, what a look at all of them finds. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "kernel/mintree.h"

static void there_is_none_at_first(void **state)
{
    struct mintree b = {0};
    (void)state;
    assert_true(mintree_least(&b) == VT_NEVER);
    mintree_set(&b, 7, VT_NEVER);
    assert_true(mintree_least(&b) == VT_NEVER);
    mintree_free(&b);
}

static void of_equal_times_the_lowest_place(void **state)
{
    struct mintree b = {0};
    (void)state;
    mintree_set(&b, 9, 5);
    mintree_set(&b, 4, 5);
    mintree_set(&b, 6, 5);
    assert_int_equal(mintree_address(&b), 4);
    mintree_set(&b, 4, VT_NEVER);
    assert_int_equal(mintree_address(&b), 6);
    mintree_free(&b);
}

static void as_looking_at_all(void **state)
{
    enum { PLACES = 300 };
    struct mintree b = {0};
    vtime time[PLACES];
    (void)state;
    for (int p = 0; p < PLACES; p++)
        time[p] = VT_NEVER;
    srand(1);
    for (int i = 0; i < 20000; i++) {
        int address = rand() % (i < 10000 ? 10 + i / 50 : PLACES), least = 0;
        time[address] = rand() % 4 ? (vtime)(rand() % 1000) : VT_NEVER;
        mintree_set(&b, (uint32_t)address, time[address]);
        for (int p = 1; p < PLACES; p++)
            if (time[p] < time[least])
                least = p;
        assert_true(mintree_least(&b) == time[least]);
        assert_true(time[least] == VT_NEVER || (int)mintree_address(&b) == least);
    }
    mintree_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(there_is_none_at_first),
        cmocka_unit_test(of_equal_times_the_lowest_place),
        cmocka_unit_test(as_looking_at_all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
