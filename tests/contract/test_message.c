/* Type selection, as nx.h has it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "nx_api/contract/message.h"

static void a_type_selects_itself_only(void **state)
{
    (void)state;
    assert_true(mailbox_selects(7, 7));
    assert_false(mailbox_selects(7, 8));
    assert_true(mailbox_selects(0, 0));
    assert_false(mailbox_selects(0, 1));
    assert_true(mailbox_selects(1600000000, 1600000000));
}

static void minus_one_selects_any_type(void **state)
{
    (void)state;
    assert_true(mailbox_selects(-1, 0));
    assert_true(mailbox_selects(-1, 999999999));
    assert_true(mailbox_selects(-1, 1073741824));
}

static void reserved_types_are_selected_by_themselves_only(void **state)
{
    (void)state;
    assert_true(mailbox_selects(1000000000, 1000000000));
    assert_false(mailbox_selects(-1, 1000000000));
    assert_false(mailbox_selects((int32_t)(0x80000000u | 1u << 30), 1073741823));
}

static void other_negative_values_are_masks_of_types_0_to_29(void **state)
{
    int64_t types_3_and_29 = (int32_t)(0x80000000u | 1u << 3 | 1u << 29);
    (void)state;
    for (int type = 0; type < 40; type++)
        assert_int_equal(mailbox_selects(types_3_and_29, type), type == 3 || type == 29);
}

static void bit_30_of_a_mask_selects_all_types_from_30_up(void **state)
{
    int64_t mask = (int32_t)(0x80000000u | 1u << 30);
    (void)state;
    assert_false(mailbox_selects(mask, 29));
    assert_true(mailbox_selects(mask, 30));
    assert_true(mailbox_selects(mask, 999999999));
    assert_true(mailbox_selects(mask, 1073741824));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_type_selects_itself_only),
        cmocka_unit_test(minus_one_selects_any_type),
        cmocka_unit_test(reserved_types_are_selected_by_themselves_only),
        cmocka_unit_test(other_negative_values_are_masks_of_types_0_to_29),
        cmocka_unit_test(bit_30_of_a_mask_selects_all_types_from_30_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
