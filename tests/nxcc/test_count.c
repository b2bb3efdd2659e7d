/* test_count.c - the cost that a program counts is the sum over the operations it executed, whatever it does.
 *
 * digits.cfg gives each class its own decimal digits, so the expected costs below read as counts of
 * operations.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "counted.h"
#include "counter.h"

enum {
    INTEGER = 1,
    LOAD = 100,
    STORE = 10000,
    BRANCH = 1000000,
    FP_ADD = 100000000,
    CALL = 50,
    ARGUMENT = 3
};
static const int64_t plenty = INT64_MAX / 2;

/* Units of the statement. */
#define COST(statement) (counter_start(plenty), (void)(statement), counter_spent())

static void straight_lines(void **state)
{
    double x = 1, y = 2;
    (void)state;
    assert_int_equal(COST(c_nothing()), 0);
    assert_int_equal(COST(c_two_adds(1, 2, 3)), 2 * INTEGER);
    assert_int_equal(COST(c_add_to(&y, &x)), 2 * LOAD + FP_ADD + STORE);
    assert_int_equal(COST(c_divide(1, 3)), 37);
    assert_int_equal(COST(c_multiply(5, 7)), 7);
    assert_int_equal(COST(c_divide_by_8(100)), 3 * INTEGER);
    assert_int_equal(COST(c_from_int(3)), 59);
}

static void inlined_code_is_charged_where_it_runs(void **state)
{
    (void)state;
    assert_int_equal(COST(c_inlined(9)), 3 * INTEGER);
}

static void a_small_function_costs_its_callers(void **state)
{
    (void)state;
    assert_int_equal(COST(c_calls_small(9)), 2 * (CALL + ARGUMENT + 7 + INTEGER) + 2 * INTEGER);
}

static void each_round_of_a_loop(void **state)
{
    double x[64] = {0};
    (void)state;
    int64_t round = LOAD + FP_ADD + INTEGER + (INTEGER + BRANCH); /* element, sum, step, compare and branch */
    int64_t ten = COST(c_sum(x, 10));
    for (int n = 1; n <= 64; n++)
        assert_int_equal(COST(c_sum(x, n)), ten + (n - 10) * round);
}

/* GCC knows its trip count as a call: of __builtin_popcount. */
static void a_loop_over_bits(void **state)
{
    int64_t round = 3 * INTEGER + (INTEGER + BRANCH); /* less one, and, step; compare and branch */
    (void)state;
    int64_t one = COST(c_bits(1));
    for (int n = 1; n < 64; n++)
        assert_int_equal(COST(c_bits(-1UL >> (64 - n))), one + (n - 1) * round);
}

static void mathematics(void **state)
{
    (void)state;
    assert_int_equal(COST(c_sqrt(2.0)), 43 + 47 + BRANCH); /* root; is the argument negative? */
    assert_int_equal(COST(c_exp(2.0)), 300);
}

/* GCC makes one operation of several, which x86-64 has instructions for, and the i860 has not. */
static void operations_that_gcc_joins(void **state)
{
    (void)state;
    assert_int_equal(COST(c_fast_floor(2.5)), 900);                             /* as the library's */
    assert_int_equal(COST(c_divide_and_remainder(7, 2)), 13 + 7 + 2 * INTEGER); /* xor, too */
    assert_int_equal(COST(c_order(1, 2)), 2 * (47 + INTEGER + BRANCH));
}

static void calls_by_argument_and_result(void **state)
{
    char a[100] = "", b[100] = "";
    (void)state;
    int64_t none = COST(c_copy(a, b, 0));
    assert_int_equal(none, 500);
    for (size_t n = 1; n <= 100; n++)
        assert_int_equal(COST(c_copy(a, b, n)), none + 2 * (int64_t)n);
    assert_int_equal(COST(c_length("")), 400);
    assert_int_equal(COST(c_length("abcdefg")), 400 + 7 * 3);
    assert_int_equal(COST(c_print(a, 12345)), 200 + 5 * 7);
}

static void recursion(void **state)
{
    int64_t cost[20];
    (void)state;
    for (int n = 0; n < 20; n++)
        cost[n] = COST(c_fibonacci(n));
    int64_t own = cost[6] - cost[5] -
                  cost[4]; /* one of its recursions has become a loop, which the first rounds show */
    assert_int_equal(cost[0], cost[1]);
    assert_true(own > 0);
    for (int n = 6; n < 20; n++)
        assert_int_equal(cost[n], cost[n - 1] + cost[n - 2] + own);
}

static void calls_through_pointers_and_tail_calls(void **state)
{
    (void)state;
    assert_int_equal(COST(c_call_through(c_nothing)), CALL + INTEGER);
    assert_int_equal(COST(c_tail_call(c_nothing)), CALL);
}

static void functions_found_pure_still_count(void **state)
{
    (void)state;
    int64_t none = COST(c_pure_calls(0)), two = COST(c_pure_calls(2)), four = COST(c_pure_calls(4));
    assert_true(two - none > 12 * BRANCH); /* the trips of their loops */
    assert_int_equal(COST(c_pure_calls(50)), two + 24 * (four - two));
}

static int compared;

static int counting_compare(const void *a, const void *b)
{
    compared++;
    return c_compare(a, b);
}

static void callbacks_from_the_library(void **state)
{
    int a[50], b[50], two[2] = {1, 2};
    (void)state;
    for (int i = 0; i < 50; i++)
        a[i] = b[i] = i * 37 % 50;
    compared = 0;
    qsort(b, 50, sizeof *b, counting_compare);
    int64_t compare = COST(c_compare(&two[0], &two[1]));
    assert_true(compare > 2 * LOAD);
    assert_int_equal(COST(c_sort(a, 50)), 600 + 50 * 20 + compared * compare);
    assert_memory_equal(a, b, sizeof a);
}

static void switches_and_computed_gotos(void **state)
{
    static const unsigned char end[] = {0}, add[] = {1, 0}, twice[] = {2, 0}, both[] = {1, 2, 1, 2, 2, 1, 0};
    (void)state;
    int64_t none = COST(c_goto(end)), a = COST(c_goto(add)) - none, t = COST(c_goto(twice)) - none;
    assert_true(a > 0 && t > 0);
    assert_int_equal(c_goto(both), ((1 + 1) * 2 + 1) * 2 * 2 + 1);
    assert_int_equal(COST(c_goto(both)), none + 3 * a + 3 * t);
    for (int i = 0; i < 8; i++)
        assert_true(COST(c_switch(i)) >= 17);
}

static void asm_goto(void **state)
{
    (void)state;
    assert_int_equal(c_asm_goto(0), 1);
    assert_int_equal(c_asm_goto(5), 7);
    assert_int_equal(COST(c_asm_goto(0)), 2 * INTEGER);
}

static void setjmp_and_longjmp(void **state)
{
    (void)state;
    int64_t none = COST(c_jump_back(0)), one = COST(c_jump_back(1)), two = COST(c_jump_back(2));
    assert_true(one > none && two - one == one - none);
    assert_int_equal(c_jump_back(20), 21);
    assert_int_equal(COST(c_jump_back(20)), none + 20 * (one - none));
    int64_t shallow = COST(c_jump_out(1)), deep = COST(c_jump_out(2));
    assert_true(deep > shallow);
    assert_int_equal(COST(c_jump_out(30)), shallow + 29 * (deep - shallow));
    assert_int_equal(c_never_returns(3), 5);
    assert_true(COST(c_never_returns(3)) > 2 * CALL);
}

static void nested_functions(void **state)
{
    (void)state;
    int64_t one = COST(c_nested(1)), two = COST(c_nested(2));
    assert_int_equal(c_nested(10), 45);
    assert_int_equal(COST(c_nested(10)), one + 9 * (two - one));
}

static void variable_arguments_and_structures(void **state)
{
    struct big b = {{1}};
    (void)state;
    assert_int_equal(c_varargs(3, 1L, 2L, 3L), 6);
    int64_t one = COST(c_varargs(1, 1L)), two = COST(c_varargs(2, 1L, 2L));
    assert_int_equal(COST(c_varargs(4, 1L, 2L, 3L, 4L)), one + 3 * (two - one));
    assert_int_equal(c_struct(b).v[15], 15);
}

static void loops_with_two_entries(void **state)
{
    (void)state;
    int64_t a = COST(c_irreducible(3, 0)), b = COST(c_irreducible(6, 0)), c = COST(c_irreducible(9, 0));
    assert_int_equal(c - b, b - a);
    assert_true(b > a);
}

/* A call may change the counter: here the simulator takes 12345 units in each. */
static void steal(void)
{
    *nxc_image.left -= 12345;
}

static void nothing(void) {}

static void what_a_call_changes_is_kept(void **state)
{
    (void)state;
    int64_t plain = COST(c_while_others(20, nothing));
    assert_int_equal(COST(c_while_others(20, steal)), plain + 20 * 12345);
}

/* --- preemption --- */

static void everything(double *result)
{
    static const unsigned char code[] = {1, 2, 1, 2, 2, 1, 0};
    double x[64];
    int a[40];
    for (int i = 0; i < 64; i++)
        x[i] = 1.0 / (i + 1);
    for (int i = 0; i < 40; i++)
        a[i] = i * 17 % 40;
    c_sort(a, 40);
    *result = c_sum(x, 64) + c_many_registers(x, 40) + (double)c_fibonacci(12) + a[7] + c_pure_calls(5) +
              (double)c_goto(code) + c_jump_back(9) + c_jump_out(9) + (double)c_nested(12) + c_switch(5) +
              (double)c_irreducible(30, 1) + (double)c_varargs(3, 1L, 2L, 3L) + c_never_returns(1);
}

static void preemption_changes_neither_result_nor_cost(void **state)
{
    double expected, result;
    (void)state;
    int64_t cost = COST(everything(&expected));
    for (int64_t budget = 1; budget < cost; budget = budget * 5 / 2 + 1) {
        counter_start(budget);
        everything(&result);
        assert_int_equal(counter_spent(), cost);
        assert_true(counter.preemptions > 0);
        assert_memory_equal(&result, &expected, sizeof result);
    }
}

/* A poll strikes in the first trip in which the budget is overdrawn, so at most one trip late. */
static void preemption_comes_at_its_time(void **state)
{
    double x[64] = {0};
    (void)state;
    int64_t round = COST(c_sum(x, 21)) - COST(c_sum(x, 20));
    for (int64_t budget = round; budget < 30 * round; budget += round / 3) {
        counter_start(budget);
        c_sum(x, 64);
        assert_true(counter.preemptions > 0);
        assert_in_range(counter.overshoot, 1, round);
    }
}

/* What is due in the course of a long library call does not wait for its end. */
/* How often a call that costs `all` is preempted, at the ends of parts of 400 clocks, which are reckoned from
 * its end. */
static int64_t preemptions(int64_t all, int64_t budget)
{
    enum { PART = 400 * NXC_UNITS_PER_CLOCK };
    int64_t count = 0;
    for (int64_t left = all; left > budget; count++)
        left = (left - budget - 1) / PART * PART;
    return count;
}

static void a_long_call_is_preempted_in_time(void **state)
{
    static char a[MUCH], b[MUCH];
    (void)state;
    for (int64_t budget = 1000; budget < 2 * MUCH; budget *= 3) {
        counter_start(budget);
        c_copy_all(a, b);
        assert_int_equal(counter_spent(), 500 + 2 * MUCH);
        assert_int_equal(counter.preemptions, preemptions(500 + 2 * MUCH, budget));
        assert_in_range(counter.overshoot, 1, 400 * NXC_UNITS_PER_CLOCK);
    }
}

static void deep_recursion_is_preempted(void **state)
{
    (void)state;
    int64_t round = COST(c_fibonacci(3));
    counter_start(round);
    c_fibonacci(15);
    assert_true(counter.preemptions > 100);
    assert_in_range(counter.overshoot, 1, round);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(straight_lines),
        cmocka_unit_test(inlined_code_is_charged_where_it_runs),
        cmocka_unit_test(a_small_function_costs_its_callers),
        cmocka_unit_test(each_round_of_a_loop),
        cmocka_unit_test(a_loop_over_bits),
        cmocka_unit_test(mathematics),
        cmocka_unit_test(operations_that_gcc_joins),
        cmocka_unit_test(calls_by_argument_and_result),
        cmocka_unit_test(recursion),
        cmocka_unit_test(calls_through_pointers_and_tail_calls),
        cmocka_unit_test(functions_found_pure_still_count),
        cmocka_unit_test(callbacks_from_the_library),
        cmocka_unit_test(switches_and_computed_gotos),
        cmocka_unit_test(asm_goto),
        cmocka_unit_test(setjmp_and_longjmp),
        cmocka_unit_test(nested_functions),
        cmocka_unit_test(variable_arguments_and_structures),
        cmocka_unit_test(loops_with_two_entries),
        cmocka_unit_test(what_a_call_changes_is_kept),
        cmocka_unit_test(preemption_changes_neither_result_nor_cost),
        cmocka_unit_test(preemption_comes_at_its_time),
        cmocka_unit_test(a_long_call_is_preempted_in_time),
        cmocka_unit_test(deep_recursion_is_preempted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
