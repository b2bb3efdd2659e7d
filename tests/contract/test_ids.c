/* Message ids: numbers from 1 on, the first free one, groups, and ids that are ignored. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "nx_api/contract/ids.h"

enum { MOST = 20 };

struct node {
    struct mailbox_ids ids;
};

static struct node node;

/* The test's back end: a receive is complete when the test says so. */
struct mailbox_ids *mailbox_ids(const struct node *n)
{
    return (struct mailbox_ids *)&n->ids;
}

bool mailbox_complete(struct node *n, const struct receive *r)
{
    (void)n;
    return r->complete;
}

void mailbox_drop(struct receive *r)
{
    (void)r;
}

void mailbox_unfollow(struct send *s)
{
    (void)s;
}

static int begin(void **state)
{
    (void)state;
    node.ids = (struct mailbox_ids){0};
    return 0;
}

static int end(void **state)
{
    (void)state;
    ids_end(&node.ids);
    return 0;
}

static long new_receive(bool complete)
{
    long id = mailbox_id_new(&node, ID_RECEIVES, MOST);
    mailbox_id_receive(&node, id)->complete = complete;
    return id;
}

static void ids_begin_at_1_and_are_limited(void **state)
{
    (void)state;
    for (long i = 1; i <= MOST; i++)
        assert_int_equal(mailbox_id_new(&node, ID_RECEIVES, MOST), i);
    assert_int_equal(mailbox_id_new(&node, ID_RECEIVES, MOST), -1);
    assert_int_equal(node.ids.used, MOST);
}

static void the_first_free_id_is_given_out(void **state)
{
    (void)state;
    for (int i = 0; i < MOST; i++)
        new_receive(false);
    mailbox_id_release(&node, 17);
    mailbox_id_release(&node, 3);
    assert_false(mailbox_id_is_valid(&node, 3));
    assert_int_equal(mailbox_id_new(&node, ID_RECEIVES, MOST), 3);
    assert_int_equal(mailbox_id_new(&node, ID_RECEIVES, MOST), 17);
}

/* Over many blocks: each id has its own receive, and the first free one is found, wherever it is. */
static void many_ids_are_told_apart(void **state)
{
    enum { MANY = 1000 };
    (void)state;
    for (long i = 1; i <= MANY; i++) {
        assert_int_equal(mailbox_id_new(&node, ID_RECEIVES, MANY), i);
        mailbox_id_receive(&node, i)->room = (size_t)i;
    }
    for (long i = 1; i <= MANY; i++)
        assert_int_equal(mailbox_id_receive(&node, i)->room, i);
    assert_false(mailbox_id_is_valid(&node, MANY + 1));
    mailbox_id_release(&node, 998);
    mailbox_id_release(&node, 500);
    mailbox_id_release(&node, 2);
    assert_int_equal(mailbox_id_new(&node, ID_RECEIVES, MANY), 2);
    assert_int_equal(mailbox_id_new(&node, ID_RECEIVES, MANY), 500);
    assert_int_equal(mailbox_id_new(&node, ID_RECEIVES, MANY), 998);
    assert_int_equal(mailbox_id_new(&node, ID_RECEIVES, MANY), -1);
}

static void other_numbers_are_no_ids(void **state)
{
    (void)state;
    new_receive(false);
    assert_true(mailbox_id_is_valid(&node, 1));
    assert_false(mailbox_id_is_valid(&node, 0));
    assert_false(mailbox_id_is_valid(&node, -1));
    assert_false(mailbox_id_is_valid(&node, 2));
    assert_false(mailbox_id_is_valid(&node, 1000));
}

static void a_merged_id_is_complete_when_all_parts_are(void **state)
{
    (void)state;
    long a = new_receive(true), b = new_receive(false), c = mailbox_id_new(&node, ID_SENDS, MOST);
    mailbox_id_merge(&node, a, b);
    mailbox_id_merge(&node, a, c);
    assert_false(mailbox_id_is_valid(&node, b));
    assert_false(mailbox_id_is_complete(&node, a));
    mailbox_id_receive(&node, b)->complete = true;
    assert_false(mailbox_id_is_complete(&node, a));
    mailbox_id_send(&node, c)->done = true;
    assert_true(mailbox_id_is_complete(&node, a));
    mailbox_id_release(&node, a);
    assert_int_equal(node.ids.used, 0);
}

/* A pass over the ignored ids looks at each once: one that completes behind the pass waits for the next. */
static void ignored_ids_are_taken_in_one_pass(void **state)
{
    (void)state;
    long late = new_receive(false), first = new_receive(true), used = new_receive(true),
         last = new_receive(true);
    mailbox_id_ignore(&node, late), mailbox_id_ignore(&node, first), mailbox_id_ignore(&node, last);
    assert_false(mailbox_id_is_valid(&node, first));
    assert_true(mailbox_id_is_valid(&node, used));
    assert_int_equal(mailbox_id_take_ignored(&node, 0), first);
    mailbox_id_release(&node, first);
    mailbox_id_receive(&node, late)->complete = true;
    assert_int_equal(mailbox_id_take_ignored(&node, first), last);
    mailbox_id_release(&node, last);
    assert_int_equal(mailbox_id_take_ignored(&node, last), -1);
    assert_int_equal(mailbox_id_take_ignored(&node, 0), late);
    mailbox_id_release(&node, late);
    assert_int_equal(mailbox_id_take_ignored(&node, 0), -1);
    assert_int_equal(node.ids.used, 1);
}

#define ON_NEW_IDS(test) cmocka_unit_test_setup_teardown(test, begin, end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        ON_NEW_IDS(ids_begin_at_1_and_are_limited),
        ON_NEW_IDS(the_first_free_id_is_given_out),
        ON_NEW_IDS(many_ids_are_told_apart),
        ON_NEW_IDS(other_numbers_are_no_ids),
        ON_NEW_IDS(a_merged_id_is_complete_when_all_parts_are),
        ON_NEW_IDS(ignored_ids_are_taken_in_one_pass),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
