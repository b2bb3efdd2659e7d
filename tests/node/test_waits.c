/* The table of what a node has waited for: one entry for a call and type, few in all, and no wait is lost. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "node/waits.h"

static vtime idle_in_all(const struct node_waits *w)
{
    vtime all = 0;
    for (uint32_t i = 0; i < w->count; i++)
        all += w->list[i].idle;
    return all;
}

static void a_call_and_type_have_one_entry(void **state)
{
    struct node_waits w = {0};
    (void)state;
    for (int i = 0; i < 10; i++)
        waits_add(&w, "crecv", true, i % 2, 3);
    waits_add(&w, "gsync", false, 7, 3);
    assert_int_equal(w.count, 3);
    assert_int_equal(w.list[0].waits, 5);
    assert_int_equal(idle_in_all(&w), 33);
    waits_free(&w);
}

static void of_ever_new_types_the_later_ones_share_an_entry(void **state)
{
    struct node_waits w = {0};
    (void)state;
    for (int i = 0; i < 100000; i++)
        waits_add(&w, "MPI_Recv", true, i, 2);
    assert_true(w.count < 1000);
    assert_false(w.list[w.count - 1].has_type);
    assert_int_equal(idle_in_all(&w), 200000);
    waits_free(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_call_and_type_have_one_entry),
        cmocka_unit_test(of_ever_new_types_the_later_ones_share_an_entry),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
