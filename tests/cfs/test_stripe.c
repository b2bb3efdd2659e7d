/* Stripes: blocks go round robin over a file's disks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "cfs/stripe.h"

enum { BLOCK = 4096 };

static void blocks_go_round_robin_over_all_disks(void **state)
{
    (void)state;
    for (uint64_t b = 0; b < 25; b++) {
        struct stripe s = stripe_first(NULL, 10, BLOCK, b * BLOCK, BLOCK);
        assert_int_equal(s.block, b);
        assert_int_equal(s.disk, b % 10);
        assert_int_equal(s.row, b / 10);
        assert_int_equal(s.offset, 0);
        assert_int_equal(s.bytes, BLOCK);
    }
}

static void a_restricted_file_uses_its_disks_only(void **state)
{
    const uint32_t disks[] = {7, 2};
    (void)state;
    assert_int_equal(stripe_first(disks, 2, BLOCK, 0, 1).disk, 7);
    assert_int_equal(stripe_first(disks, 2, BLOCK, BLOCK, 1).disk, 2);
    assert_int_equal(stripe_first(disks, 2, BLOCK, 5 * BLOCK, 1).disk, 2);
    assert_int_equal(stripe_first(disks, 2, BLOCK, 5 * BLOCK, 1).row, 2);
}

static void pieces_end_at_blocks_and_add_up(void **state)
{
    uint64_t at = 4000, left = 10000;
    const uint32_t expected[] = {96, 4096, 4096, 1712};
    (void)state;
    for (int i = 0; left > 0; i++) {
        struct stripe s = stripe_first(NULL, 3, BLOCK, at, left);
        assert_int_equal(s.bytes, expected[i]);
        assert_int_equal(s.block * BLOCK + s.offset, at);
        at += s.bytes, left -= s.bytes;
    }
    assert_int_equal(at, 14000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blocks_go_round_robin_over_all_disks),
        cmocka_unit_test(a_restricted_file_uses_its_disks_only),
        cmocka_unit_test(pieces_end_at_blocks_and_add_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
