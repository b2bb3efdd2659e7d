/* Fibers keep their place and their floating-point state, and any number of them take turns; with threads of
 * their own, too. */
#include <errno.h>
#include <fenv.h>
#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
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

/* --- floating-point flags --- */

struct flagged {
    struct fiber self;
    char stack[STACK];
    int raises, before, after;
};

static void raise_and_look(void *arg)
{
    struct flagged *f = arg;
    f->before = fetestexcept(FE_ALL_EXCEPT);
    feraiseexcept(f->raises);                /* overflow: by the x87 unit; invalid: by SSE */
    feenableexcept(f->raises & FE_OVERFLOW); /* it would trap at the next operation */
    fiber_yield(&f->self);
    f->after = fetestexcept(FE_ALL_EXCEPT);
    feclearexcept(FE_ALL_EXCEPT);
    fiber_finish(&f->self);
}

static void flags_of_exceptions_are_a_fibers_own(void **state)
{
    static struct flagged f[3] = {{.raises = FE_OVERFLOW}, {.raises = FE_INVALID}, {.raises = 0}};
    (void)state;
    feclearexcept(FE_ALL_EXCEPT);
    for (int turn = 0; turn < 2; turn++)
        for (int i = 0; i < 3; i++) {
            if (turn == 0)
                fiber_begin(&f[i].self, f[i].stack, STACK, raise_and_look, &f[i]);
            fiber_resume(&f[i].self);
            assert_int_equal(fetestexcept(FE_ALL_EXCEPT), 0);
        }
    for (int i = 0; i < 3; i++) {
        assert_int_equal(f[i].before, 0);
        assert_int_equal(f[i].after, f[i].raises);
        fiber_end(&f[i].self);
    }
}

/* --- with threads --- */

static int begun, ended; /* begun: what begin() returns */

static void *note_begin(void)
{
    return &begun;
}

static void note_end(void *own)
{
    assert_ptr_equal(own, &begun);
    ended++;
}

struct threaded {
    struct fiber self;
    pthread_t resumer, thread;
    char name[16];
    bool on_its_stack;
    int seen_errno, turns;
    char stack[STACK];
};

static void look_round(struct threaded *t)
{
    char here;
    t->thread = pthread_self();
    pthread_getname_np(pthread_self(), t->name, sizeof t->name);
    t->on_its_stack = &here >= t->stack && &here < t->stack + STACK;
}

static void turn_for_ever(void *arg)
{
    struct threaded *t = arg;
    for (;; t->turns++) {
        look_round(t);
        t->seen_errno = errno;
        errno = 1000 + t->turns;
        fiber_yield(&t->self);
    }
}

static void one_turn(void *arg)
{
    struct threaded *t = arg;
    look_round(t);
    fiber_finish(&t->self);
}

static struct threaded *make(void (*run)(void *arg), const char *name)
{
    struct threaded *t = calloc(1, sizeof *t);
    fiber_begin(&t->self, t->stack, STACK, run, t);
    assert_true(fiber_take_thread(&t->self, name, note_begin, note_end));
    return t;
}

static void a_fiber_may_have_a_thread(void **state)
{
    struct threaded *t = make(turn_for_ever, "node 3");
    (void)state;
    for (int i = 0; i < TURNS; i++) {
        errno = 50 + i;
        fiber_resume(&t->self);
        assert_int_equal(t->seen_errno, 50 + i);
        assert_int_equal(errno, 1000 + i);
        assert_string_equal(t->name, "node 3");
        assert_true(t->on_its_stack);
        assert_false(pthread_equal(t->thread, pthread_self()));
        assert_null(fiber_current());
    }
    ended = 0;
    fiber_end(&t->self); /* in the middle of its functions */
    assert_int_equal(ended, 1);
    assert_int_equal(t->turns, TURNS - 1);
    free(t);
}

static void it_may_finish_or_never_begin(void **state)
{
    (void)state;
    struct threaded *finishes = make(one_turn, "a"), *never = make(one_turn, "b");
    ended = 0;
    fiber_resume(&finishes->self);
    assert_true(finishes->on_its_stack);
    fiber_end(&finishes->self);
    fiber_end(&never->self);
    assert_int_equal(ended, 2);
    assert_false(never->on_its_stack);
    free(finishes);
    free(never);
}

static void note_where(void *arg)
{
    look_round(arg);
}

static bool takes_sigint(void)
{
    sigset_t now;
    pthread_sigmask(SIG_BLOCK, NULL, &now);
    return !sigismember(&now, SIGINT);
}

static void note_sigint(void *arg)
{
    *(bool *)arg = takes_sigint();
}

static void look_at_sigint(void *arg)
{
    struct threaded *t = arg;
    t->turns = takes_sigint();
    fiber_yield(&t->self);
    t->turns = takes_sigint();
    fiber_finish(&t->self);
}

static void who_has_the_turn_takes_sigint(void **state)
{
    struct threaded *t = make(look_at_sigint, "node 3");
    bool waiting = true;
    (void)state;
    for (int i = 0; i < 2; i++) {
        t->turns = 0;
        fiber_call_there(&t->self, note_sigint, &waiting);
        assert_false(waiting);
        fiber_resume(&t->self);
        assert_true(t->turns);
        assert_true(takes_sigint());
    }
    fiber_end(&t->self);
    free(t);
}

/* While it waits, other code may run there: a debugger then shows the fiber's calls. */
static void calls_go_where_it_waits(void **state)
{
    struct threaded *t = make(turn_for_ever, "node 3");
    (void)state;
    fiber_resume(&t->self);
    t->on_its_stack = false, t->thread = pthread_self();
    fiber_call_there(&t->self, note_where, t);
    assert_true(t->on_its_stack);
    assert_false(pthread_equal(t->thread, pthread_self()));
    fiber_resume(&t->self);
    assert_int_equal(t->turns, 1);
    fiber_end(&t->self);
    free(t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(fibers_take_turns),
                                       cmocka_unit_test(flags_of_exceptions_are_a_fibers_own),
                                       cmocka_unit_test(a_fiber_may_have_a_thread),
                                       cmocka_unit_test(it_may_finish_or_never_begin),
                                       cmocka_unit_test(who_has_the_turn_takes_sigint),
                                       cmocka_unit_test(calls_go_where_it_waits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
