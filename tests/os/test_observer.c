/* A subscriber of what happens to nodes, linked without a change to sim/os: it counts calls that are deferred
 * and committed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "os/observer.h"

struct counter {
    struct observer observer; /* first */
    int begun, ended, committed;
    vtime committed_at;
};

static void begins(struct observer *o, struct node *n)
{
    (void)n;
    ((struct counter *)o)->begun++;
}

static void commits(struct observer *o, struct node *n, vtime t)
{
    (void)n;
    ((struct counter *)o)->committed++, ((struct counter *)o)->committed_at = t;
}

static void ends(struct observer *o, struct node *n, vtime t)
{
    (void)t;
    ((struct counter *)o)->ended++;
    observer_remove(n, o);
}

static const struct announcements counts = {.call_begins = begins, .committed = commits, .ends = ends};
static const struct announcements counts_commits = {.committed = commits};

static void announce(struct node *n)
{
    ANNOUNCE(n, call_begins);
    ANNOUNCE(n, call_ends);
    ANNOUNCE(n, committed, 7);
}

static void test_nobody(void **state)
{
    (void)state;
    struct node n = {0};
    announce(&n);
    assert_null(n.observers);
    assert_null(observer_of(&n, &counts));
}

static void test_several(void **state)
{
    (void)state;
    struct node n = {0}, other = {0};
    struct counter a = {.observer.hears = &counts}, b = {.observer.hears = &counts_commits},
                   c = {.observer.hears = &counts};
    observer_add(&n, &a.observer);
    observer_add(&n, &b.observer);
    observer_add(&other, &c.observer);
    assert_ptr_equal(observer_of(&n, &counts), &a);
    assert_ptr_equal(observer_of(&n, &counts_commits), &b);
    announce(&n);
    announce(&n);
    assert_int_equal(a.begun, 2);
    assert_int_equal(a.committed, 2);
    assert_int_equal(a.committed_at, 7);
    assert_int_equal(b.begun, 0); /* has not asked for it */
    assert_int_equal(b.committed, 2);
    assert_int_equal(c.begun, 0); /* of another node */
}

/* One that removes itself is told once, and those after it are told all the same. */
static void test_removed(void **state)
{
    (void)state;
    struct node n = {0};
    struct counter a = {.observer.hears = &counts}, b = {.observer.hears = &counts};
    observer_add(&n, &a.observer);
    observer_add(&n, &b.observer);
    ANNOUNCE(&n, ends, 9);
    ANNOUNCE(&n, ends, 9);
    assert_int_equal(a.ended, 1);
    assert_int_equal(b.ended, 1);
    assert_null(n.observers);
}

/* What a node's observers want to be told follows them: one may come to want more, and leave. */
static void test_wants(void **state)
{
    (void)state;
    struct node n = {0};
    struct counter a = {.observer.hears = &counts_commits}, b = {.observer.hears = &counts_commits};
    observer_add(&n, &a.observer);
    observer_add(&n, &b.observer);
    assert_true(IS_HEARD(&n, committed));
    assert_false(IS_HEARD(&n, call_begins));
    announce(&n);
    observer_wants(&n, &a.observer, &counts);
    assert_true(IS_HEARD(&n, call_begins));
    assert_false(IS_HEARD(&n, call_ends));
    announce(&n);
    assert_int_equal(a.begun, 1);
    assert_int_equal(a.committed, 2);
    assert_int_equal(b.begun, 0);
    observer_remove(&n, &a.observer);
    assert_false(IS_HEARD(&n, call_begins));
    assert_true(IS_HEARD(&n, committed));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_nobody), cmocka_unit_test(test_several),
                                       cmocka_unit_test(test_removed), cmocka_unit_test(test_wants)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
