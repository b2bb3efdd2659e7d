/* test_profile.c - the cost of a program built with --profile is told by function: exactly, and as written.
 *
 * The functions are those of test_count.c, with the same costs (digits.cfg).
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>
#include "counted.h"
#include "counter.h"

static const int64_t plenty = INT64_MAX / 2;

/* Units of the statement. */
#define COST(statement) (counter_start(plenty), (void)(statement), counter_spent())

static int64_t own(const char *function)
{
    return counter_of(function, NULL);
}

static void a_function_by_itself(void **state)
{
    double x[64] = {0};
    (void)state;
    assert_int_equal(COST(c_two_adds(1, 2, 3)), 2);
    assert_int_equal(own("c_two_adds"), 2);
    int64_t cost = COST(c_sum(x, 64));
    assert_int_equal(own("c_sum"), cost);
    assert_int_equal(own("c_two_adds"), 0);
}

static void inlined_code_belongs_where_it_was_written(void **state)
{
    (void)state;
    assert_int_equal(COST(c_inlined(9)), 3);
    assert_int_equal(own("twice_and_one"), 3);
    assert_int_equal(own("c_inlined"), 0);
    for (long n = 1; n < 40; n++) {
        int64_t cost = COST(c_inlined_in_loop(n));
        assert_int_equal(own("twice_and_one"), 3 * n);
        assert_int_equal(own("c_inlined_in_loop"), cost - 3 * n);
    }
}

static void a_small_function_is_told_apart_though_its_callers_pay(void **state)
{
    (void)state;
    int64_t cost = COST(c_calls_small(9));
    assert_int_equal(own("small"), 2 * (7 + 1));
    assert_int_equal(own("c_calls_small"), cost - 2 * (7 + 1));
}

static void library_calls_are_told_apart(void **state)
{
    char a[100] = "", b[100] = "";
    (void)state;
    for (size_t n = 0; n <= 100; n += 10) {
        assert_int_equal(COST(c_copy(a, b, n)), 500 + 2 * (int64_t)n);
        assert_int_equal(counter_of("c_copy", "memcpy"), 500 + 2 * (int64_t)n);
        assert_int_equal(own("c_copy"), 0);
    }
    int64_t cost = COST(c_print(a, 12345));
    assert_int_equal(counter_of("c_print", "snprintf") + own("c_print"), cost);
    assert_int_equal(counter_of("c_print", "snprintf"), 200 + 5 * 7);
}

static void recursion(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        int64_t cost = COST(c_fibonacci(n));
        assert_int_equal(own("c_fibonacci"), cost);
    }
}

static void functions_called_and_called_back(void **state)
{
    int a[50], two[2] = {1, 2};
    (void)state;
    int64_t compare = COST(c_compare(&two[0], &two[1]));
    for (int i = 0; i < 50; i++)
        a[i] = i * 37 % 50;
    int64_t cost = COST(c_sort(a, 50));
    assert_int_equal(counter_of("c_sort", "qsort"), 600 + 50 * 20);
    assert_true(own("c_compare") > 50 * compare && own("c_compare") % compare == 0);
    assert_int_equal(own("c_sort") + own("c_compare") + counter_of("c_sort", "qsort"), cost);
}

static void setjmp_and_longjmp(void **state)
{
    (void)state;
    COST(c_jump_out(1));
    int64_t one = own("deeper"), around = own("c_jump_out");
    COST(c_jump_out(2));
    int64_t each = own("deeper") - one;
    assert_true(each > 0 && around > 0);
    int64_t cost = COST(c_jump_out(30));
    assert_int_equal(own("deeper"), one + 29 * each);
    assert_int_equal(own("c_jump_out"), around);
    assert_int_equal(counter_profiled(), cost);
}

/* --- paths --- */

static void a_path_for_each_caller(void **state)
{
    (void)state;
    int64_t cost = COST(c_nested(12));
    assert_int_equal(counter_profiled(), cost);
    assert_true(counter_at_root());
    cost = COST(c_count_down(3));
    int64_t first = counter_of_path("c_count_down"), second = counter_of_path("c_count_down;c_count_down"),
            third = counter_of_path("c_count_down;c_count_down;c_count_down"),
            last = counter_of_path("c_count_down;c_count_down;c_count_down;c_count_down");
    assert_true(first > 0 && first == second && first == third && last > 0);
    assert_int_equal(3 * first + last, cost);
    assert_true(counter_at_root());
}

static void who_is_called_back_by_a_library_is_called_by_its_caller(void **state)
{
    int a[50];
    (void)state;
    for (int i = 0; i < 50; i++)
        a[i] = i * 37 % 50;
    COST(c_sort(a, 50));
    assert_true(counter_of_path("c_sort;c_compare") > 0);
    assert_int_equal(counter_of_path("c_sort;c_compare"), own("c_compare"));
    assert_true(counter_at_root());
}

static void longjmp_leaves_paths(void **state)
{
    (void)state;
    int64_t cost = COST(c_jump_out(30));
    assert_int_equal(counter_profiled(), cost);
    assert_true(counter_at_root());
    int64_t first = counter_of_path("c_jump_out;deeper");
    assert_true(first > 0 && counter_of_path("c_jump_out;deeper;deeper") > 0);
    COST((c_jump_out(30), c_jump_out(30)));
    assert_int_equal(counter_of_path("c_jump_out;deeper"), 2 * first);
}

static void deep_recursion_is_folded(void **state)
{
    (void)state;
    int64_t cost = COST(c_count_down(100000));
    assert_int_equal(own("c_count_down"), cost);
    assert_int_equal(counter_profiled(), cost);
    assert_true(counter_at_root());
}

/* --- lines --- */

static void lines_add_up(void **state)
{
    (void)state;
    int64_t cost = COST(c_inlined_in_loop(40)), own_lines = 0, inlined = 0;
    for (int line = 1; line < 1000; line++)
        own_lines += counter_of_line("c_inlined_in_loop", line),
            inlined += counter_of_line("twice_and_one", line);
    assert_int_equal(inlined, 3 * 40);
    assert_int_equal(own_lines, cost - 3 * 40);
}

/* --- interrupts --- */

static void handler(void)
{
    c_fibonacci(3);
}

static void short_handler(void)
{
    c_two_adds(1, 2, 3);
}

static void handlers_pay_for_themselves_in_a_long_call(void **state)
{
    static char a[MUCH], b[MUCH];
    (void)state;
    counter_start(1000);
    counter.handler = short_handler;
    c_copy_all(a, b);
    assert_int_equal(counter.preemptions, 5); /* after 500 units, and behind each 400 clocks */
    assert_int_equal(counter_of("c_copy_all", "memcpy"), 500 + 2 * MUCH);
    assert_int_equal(own("c_two_adds"), 2 * counter.preemptions);
    assert_int_equal(counter_profiled(), counter_spent());
}

static void handlers_pay_for_themselves(void **state)
{
    (void)state;
    int64_t each = COST(c_fibonacci(3)), all = COST(c_inlined_in_loop(1000));
    for (int64_t budget = 2 * each; budget < all; budget *= 2) {
        counter_start(budget);
        counter.handler = handler;
        c_inlined_in_loop(1000);
        assert_true(counter.preemptions > 0);
        assert_int_equal(own("twice_and_one"), 3 * 1000);
        assert_int_equal(own("c_inlined_in_loop"), all - 3 * 1000);
        assert_int_equal(own("c_fibonacci"), counter.preemptions * each);
        assert_int_equal(counter_profiled(), counter_spent());
    }
}

static jmp_buf out;

static void leave(void)
{
    longjmp(out, 1);
}

static void a_handler_may_leave_a_loop_for_good(void **state)
{
    (void)state;
    int64_t all = COST(c_inlined_in_loop(1000));
    counter_start(all / 2);
    counter.handler = leave;
    if (!setjmp(out))
        c_inlined_in_loop(1000);
    assert_int_equal(counter_profiled(), counter_spent());
    assert_in_range(own("twice_and_one"), 3 * 499, 3 * 502);
}

static void everything(void)
{
    static const unsigned char code[] = {1, 2, 1, 2, 2, 1, 0};
    double x[64] = {1};
    int a[40];
    for (int i = 0; i < 40; i++)
        a[i] = i * 17 % 40;
    c_sort(a, 40);
    c_sum(x, 64), c_many_registers(x, 40), c_fibonacci(12), c_pure_calls(5), c_goto(code), c_jump_back(9);
    c_jump_out(9), c_nested(12), c_switch(5), c_irreducible(30, 1), c_varargs(3, 1L, 2L, 3L),
        c_never_returns(1);
    c_inlined_in_loop(100);
}

static void the_functions_add_up_however_often_interrupted(void **state)
{
    (void)state;
    int64_t cost = COST(everything());
    assert_int_equal(counter_profiled(), cost);
    for (int64_t budget = 1; budget < cost; budget = budget * 5 / 2 + 1) {
        counter_start(budget);
        everything();
        assert_int_equal(counter_spent(), cost);
        assert_int_equal(counter_profiled(), cost);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_function_by_itself),
        cmocka_unit_test(inlined_code_belongs_where_it_was_written),
        cmocka_unit_test(a_small_function_is_told_apart_though_its_callers_pay),
        cmocka_unit_test(library_calls_are_told_apart),
        cmocka_unit_test(recursion),
        cmocka_unit_test(functions_called_and_called_back),
        cmocka_unit_test(setjmp_and_longjmp),
        cmocka_unit_test(a_path_for_each_caller),
        cmocka_unit_test(who_is_called_back_by_a_library_is_called_by_its_caller),
        cmocka_unit_test(longjmp_leaves_paths),
        cmocka_unit_test(deep_recursion_is_folded),
        cmocka_unit_test(lines_add_up),
        cmocka_unit_test(handlers_pay_for_themselves),
        cmocka_unit_test(handlers_pay_for_themselves_in_a_long_call),
        cmocka_unit_test(a_handler_may_leave_a_loop_for_good),
        cmocka_unit_test(the_functions_add_up_however_often_interrupted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
