/* The shadow of memory: which byte of an access is the first that may not be accessed, for each place and
 * length round the borders of what is open, compared with a list of all bytes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>
#include <unistd.h>
#include "asan/asan_shadow.h"
#include "nx_api/contract/asan.h"

enum { LOW = 1 << 20, BYTES = 1 << 16, LOOKED_AT = 160 };

static uintptr_t first_closed(const bool *open, uintptr_t at, size_t bytes)
{
    for (uintptr_t i = at; i < at + bytes; i++)
        if (!open[i - LOW])
            return i;
    return 0;
}

static void compare(const struct asan_shadow *s, const bool *open)
{
    for (uintptr_t at = LOW; at < LOW + LOOKED_AT; at++)
        for (size_t bytes = 1; at + bytes <= LOW + LOOKED_AT; bytes++)
            assert_int_equal(asan_shadow_first(s, at, bytes), first_closed(open, at, bytes));
}

/* A shadow of memory that is all the program's own. */
static void make_own(struct asan_shadow *s)
{
    int others = asan_shadow_others();
    assert_true(others >= 0);
    assert_true(asan_shadow_begin(s, LOW, BYTES, others));
    assert_true(asan_shadow_own(s, LOW, BYTES));
    close(others);
}

static void set(bool *open, size_t from, size_t bytes, bool value)
{
    memset(open + from, value, bytes);
}

static void each_byte_is_known(void **state)
{
    (void)state;
    struct asan_shadow s;
    bool open[LOOKED_AT];
    make_own(&s);
    set(open, 0, LOOKED_AT, true);
    compare(&s, open);
    asan_shadow_mark(&s, LOW, LOOKED_AT, NXC_ASAN_HEAP);
    set(open, 0, LOOKED_AT, false);
    compare(&s, open);
    for (size_t bytes = 0; bytes <= 40; bytes++) { /* a block, given and taken */
        asan_shadow_open(&s, LOW + 48, bytes);
        set(open, 48, bytes, true);
        compare(&s, open);
        asan_shadow_mark(&s, LOW + 48, 40, NXC_ASAN_FREED);
        set(open, 48, 40, false);
        compare(&s, open);
    }
    asan_shadow_end(&s);
}

static void a_zone_behind_a_variable_leaves_the_neighbours(void **state)
{
    (void)state;
    struct asan_shadow s;
    bool open[LOOKED_AT];
    for (size_t begin = 0; begin < 8; begin++)
        for (size_t bytes = 1; bytes < 20; bytes++) {
            make_own(&s);
            asan_shadow_mark(&s, LOW + begin + bytes, NXC_ASAN_ZONE, NXC_ASAN_GLOBAL);
            set(open, 0, LOOKED_AT, true);
            set(open, begin + bytes, (begin + bytes + NXC_ASAN_ZONE) / 8 * 8 - (begin + bytes), false);
            compare(&s, open);
            asan_shadow_end(&s);
        }
}

static void the_reason_is_told(void **state)
{
    (void)state;
    struct asan_shadow s;
    make_own(&s);
    asan_shadow_mark(&s, LOW + 13, 32, NXC_ASAN_LOCAL);
    assert_int_equal(asan_shadow_why(&s, LOW + 13), NXC_ASAN_LOCAL); /* in a grain with open bytes */
    assert_int_equal(asan_shadow_why(&s, LOW + 24), NXC_ASAN_LOCAL);
    asan_shadow_end(&s);
}

static void what_is_forgotten_is_open(void **state)
{
    (void)state;
    struct asan_shadow s;
    make_own(&s);
    asan_shadow_mark(&s, LOW, BYTES, NXC_ASAN_HEAP);
    asan_shadow_forget(&s, LOW + 64, BYTES - 128);
    assert_int_equal(asan_shadow_first(&s, LOW + 64, BYTES - 128), 0);
    assert_int_equal(asan_shadow_first(&s, LOW + 63, 2), LOW + 63);
    assert_int_equal(asan_shadow_first(&s, LOW + BYTES - 65, 2), LOW + BYTES - 64);
    asan_shadow_end(&s);
}

static void what_is_closed_alike_is_opened(void **state)
{
    (void)state;
    struct asan_shadow s;
    make_own(&s);
    asan_shadow_mark(&s, LOW, 40, NXC_ASAN_RETURNED);
    asan_shadow_mark(&s, LOW + 40, 8, NXC_ASAN_LOCAL);
    asan_shadow_open_alike(&s, LOW + 19);
    assert_int_equal(asan_shadow_first(&s, LOW, 16), LOW);
    assert_int_equal(asan_shadow_first(&s, LOW + 16, 32), LOW + 40);
    asan_shadow_mark(&s, LOW + BYTES - 16, 16, NXC_ASAN_RETURNED);
    asan_shadow_open_alike(&s, LOW + BYTES - 16);
    assert_int_equal(asan_shadow_first(&s, LOW + BYTES - 16, 16), 0);
    asan_shadow_end(&s);
}

static void what_has_no_shadow_is_open(void **state)
{
    (void)state;
    struct asan_shadow s;
    make_own(&s);
    asan_shadow_mark(&s, LOW, BYTES, NXC_ASAN_HEAP);
    assert_int_equal(asan_shadow_first(&s, LOW - 100, 50), 0);
    assert_int_equal(asan_shadow_first(&s, LOW + BYTES, 50), 0);
    asan_shadow_end(&s);
}

static void what_is_not_own_is_others(void **state)
{
    (void)state;
    enum { ALL = 1 << 28, OWN = 1 << 20, SHADOW_PAGE = 4096 * 8 };
    struct asan_shadow s;
    int others = asan_shadow_others();
    assert_true(asan_shadow_begin(&s, LOW, ALL, others));
    assert_true(asan_shadow_own(&s, LOW + OWN, OWN));
    close(others);
    assert_int_equal(asan_shadow_first(&s, LOW + OWN, OWN), 0);
    assert_int_equal(asan_shadow_first(&s, LOW + OWN - SHADOW_PAGE - 4, 8), LOW + OWN - SHADOW_PAGE - 4);
    assert_int_equal(asan_shadow_first(&s, LOW + 2 * OWN - 4, 8), LOW + 2 * OWN);
    const uintptr_t closed[] = {LOW, LOW + 2 * OWN, LOW + ALL - 1, LOW - 1, LOW + ALL};
    for (size_t i = 0; i < sizeof closed / sizeof *closed; i++)
        assert_int_equal(asan_shadow_why(&s, closed[i]), NXC_ASAN_OTHERS);
    asan_shadow_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_byte_is_known),
        cmocka_unit_test(what_is_not_own_is_others),
        cmocka_unit_test(a_zone_behind_a_variable_leaves_the_neighbours),
        cmocka_unit_test(the_reason_is_told),
        cmocka_unit_test(what_is_forgotten_is_open),
        cmocka_unit_test(what_is_closed_alike_is_opened),
        cmocka_unit_test(what_has_no_shadow_is_open),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
