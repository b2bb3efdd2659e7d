/* Which message a receive takes, and which receive a message completes: matching.h, with a back end of the
 * test's own. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "nx_api/contract/message.h"

struct node {
    struct node_info info;
    int error;
};

struct message {
    struct message *next;
    int32_t type, pid;
    long from;
    size_t bytes;
    const char *data;
};

#include "nx_api/contract/matching.h"

long nx_sender(const struct node *n, const struct message *m)
{
    (void)n;
    return m->from;
}

const char *nx_sender_name(const struct node *n, const struct message *m)
{
    (void)n, (void)m;
    return "a node";
}

long node_error(struct node *n, int code, const char *fmt, ...)
{
    (void)fmt;
    n->error = code;
    return -1;
}

void node_put_long(const struct node *n, long *array, size_t i, long value)
{
    (void)n;
    array[i] = value;
}

enum { ANY = -1 };
static struct node node;

static struct message of(int32_t type, long from, int32_t pid)
{
    return (struct message){.type = type, .from = from, .pid = pid};
}

static bool selects(long type, long from, long pid, struct message m)
{
    return matching_selects(&node, &(struct selector){type, from, pid}, &m);
}

static void type_node_and_process_type_all_have_to_agree(void **state)
{
    (void)state;
    assert_true(selects(7, 3, 1, of(7, 3, 1)));
    assert_false(selects(7, 3, 1, of(8, 3, 1)));
    assert_false(selects(7, 3, 1, of(7, 4, 1)));
    assert_false(selects(7, 3, 1, of(7, 3, 2)));
    assert_true(selects(ANY, ANY, ANY, of(7, 4, 2)));
    assert_true(selects(7, 0, ANY, of(7, 0, 9)));
}

static void the_first_selected_of_a_list_is_found(void **state)
{
    struct message c = of(7, 1, 0), b = of(7, 0, 0), a = of(6, 0, 0);
    (void)state;
    a.next = &b, b.next = &c;
    assert_ptr_equal(matching_first(&node, &(struct selector){7, ANY, ANY}, &a), &b);
    assert_ptr_equal(matching_first(&node, &(struct selector){7, 1, ANY}, &a), &c);
    assert_ptr_equal(matching_first(&node, &(struct selector){ANY, ANY, ANY}, &a), &a);
    assert_null(matching_first(&node, &(struct selector){7, 2, ANY}, &a));
    assert_null(matching_first(&node, &(struct selector){7, ANY, ANY}, NULL));
}

static struct receive posted_for(long type)
{
    return (struct receive){.select = {type, ANY, ANY}};
}

static void a_message_takes_the_receive_posted_first(void **state)
{
    struct posted p;
    struct receive seven = posted_for(7), any = posted_for(ANY), again = posted_for(7);
    struct message m = of(7, 0, 0);
    (void)state;
    posted_begin(&p);
    posted_append(&p, &seven), posted_append(&p, &any), posted_append(&p, &again);
    assert_ptr_equal(posted_take(&node, &p, &m), &seven);
    assert_ptr_equal(posted_take(&node, &p, &m), &any);
    assert_ptr_equal(posted_take(&node, &p, &m), &again);
    assert_null(posted_take(&node, &p, &m));
}

/* The end of the list has to move when its last receive leaves. */
static void receives_are_posted_behind_one_that_was_removed(void **state)
{
    struct posted p;
    struct receive first = posted_for(7), last = posted_for(8), next = posted_for(9);
    struct message m = of(9, 0, 0);
    (void)state;
    posted_begin(&p);
    posted_append(&p, &first), posted_append(&p, &last);
    assert_true(posted_remove(&p, &last));
    assert_false(posted_remove(&p, &last));
    posted_append(&p, &next);
    assert_ptr_equal(posted_take(&node, &p, &m), &next);
    posted_append(&p, &last);
    assert_ptr_equal(p.first, &first);
    assert_ptr_equal(first.next, &last);
    assert_null(last.next);
}

static void a_message_that_fits_is_copied_and_described(void **state)
{
    char buf[4] = "...";
    long info[8] = {0, 0, 0, 0, 5, 6, 7, 8};
    struct message m = {.type = 7, .pid = 2, .from = 3, .bytes = 2, .data = "ab"};
    struct receive r = {.m = &m, .buf = buf, .room = 2, .info = info};
    (void)state;
    assert_int_equal(matching_take(&node, &r), 0);
    assert_string_equal(buf, "ab.");
    assert_memory_equal(info, ((long[]){7, 2, 3, 2, 5, 6, 7, 8}), sizeof info);
    assert_int_equal(node.info.count, 2);
}

static void one_that_does_not_fit_leaves_the_buffer(void **state)
{
    char buf[4] = "...";
    struct message m = {.type = 7, .bytes = 3, .data = "abc"};
    struct receive r = {.m = &m, .buf = buf, .room = 2};
    (void)state;
    assert_int_equal(matching_take(&node, &r), -1);
    assert_int_equal(node.error, EQMSGLONG);
    assert_string_equal(buf, "...");
    assert_int_equal(node.info.count, 3);
}

static void the_librarys_messages_are_not_described(void **state)
{
    struct message m = {.type = 1000000000, .bytes = 0};
    struct receive r = {.m = &m};
    (void)state;
    node.info.type = 7;
    assert_int_equal(matching_take(&node, &r), 0);
    assert_int_equal(node.info.type, 7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(type_node_and_process_type_all_have_to_agree),
        cmocka_unit_test(the_first_selected_of_a_list_is_found),
        cmocka_unit_test(a_message_takes_the_receive_posted_first),
        cmocka_unit_test(receives_are_posted_behind_one_that_was_removed),
        cmocka_unit_test(a_message_that_fits_is_copied_and_described),
        cmocka_unit_test(one_that_does_not_fit_leaves_the_buffer),
        cmocka_unit_test(the_librarys_messages_are_not_described),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
