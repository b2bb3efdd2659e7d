/* Fibers keep their place and their floating-point state, and any number of them take turns. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "kernel/fiber.h"

enum { STACK = 1 << 16, TURNS = 5 };

struct turn {
    struct fiber self;
    void *stack;
    int count;
    double sum;
};

static void count_turns(void *arg)
{
    struct turn *t = arg;
    for (int i = 0; i < TURNS; i++) {
        t->count++;
        t->sum += 0.1 * i;
        fiber_yield(&t->self);
    }
    fiber_finish(&t->self);
}

static void fibers_take_turns(void **state)
{
    struct turn t[20] = {0};
    (void)state;
    for (int i = 0; i < 20; i++) {
        t[i].stack = malloc(STACK);
        fiber_begin(&t[i].self, t[i].stack, STACK, count_turns, &t[i]);
    }
    for (int turn = 1; turn <= TURNS; turn++)
        for (int i = 0; i < 20; i++) {
            fiber_resume(&t[i].self);
            assert_int_equal(t[i].count, turn);
        }
    for (int i = 0; i < 20; i++) {
        fiber_resume(&t[i].self); /* to its end */
        assert_true(t[i].sum > 0.999 && t[i].sum < 1.001);
        fiber_end(&t[i].self);
        free(t[i].stack);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(fibers_take_turns)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
