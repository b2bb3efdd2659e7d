/* The shadow of memory: a cell for each word, which stays where it is; forgetting takes whole words; and the
 * memory is what race_shadow.h promises. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include "races/race_shadow.h"

#define AT ((uintptr_t)0x40001000)

static struct race_cell *cell_of(struct race_shadow *s, uintptr_t address)
{
    return &race_shadow_page(s, address)->of[address % RACE_PAGE / RACE_WORD];
}

static void each_word_has_a_cell(void **state)
{
    struct race_shadow *s = *state;
    struct race_cell *c = cell_of(s, AT);
    assert_ptr_equal(cell_of(s, AT + 3), c);
    assert_ptr_equal(cell_of(s, AT + 4), c + 1);
    assert_int_equal(c->of[RACE_MAIN_WRITE].epoch, 0);
}

static void cells_stay_when_there_are_many(void **state)
{
    enum { PAGES = 1000 };
    struct race_shadow *s = *state;
    for (unsigned i = 0; i < PAGES; i++)
        cell_of(s, AT + (uintptr_t)i * RACE_PAGE)->of[RACE_MAIN_READ].epoch = i + 1;
    for (unsigned i = 0; i < PAGES; i++)
        assert_int_equal(cell_of(s, AT + (uintptr_t)i * RACE_PAGE)->of[RACE_MAIN_READ].epoch, i + 1);
    size_t most = (size_t)PAGES * (RACE_PAGE * 12 + 192) +
                  16384; /* 48 bytes for 4, the stretches, and where they are */
    assert_true(race_shadow_bytes(s) <= most);
}

static void forgetting_ends_the_stretches_of_the_page(void **state)
{
    struct race_shadow *s = *state;
    struct race_cells *c = race_shadow_page(s, AT);
    c->known[RACE_MAIN_READ] = (struct race_stretch){7, 0, RACE_PAGE};
    race_shadow_forget(s, AT + 8, 4);
    assert_ptr_equal(race_shadow_page(s, AT), c);
    assert_int_equal(c->known[RACE_MAIN_READ].epoch, 0);
}

static void forgetting_takes_the_words_that_are_named(void **state)
{
    struct race_shadow *s = *state;
    for (uintptr_t i = 0; i < 1024; i++)
        cell_of(s, AT + 4 * i)->of[RACE_HANDLER_WRITE].epoch = 7;
    race_shadow_forget(s, AT + 8, 4 * 1000);
    for (uintptr_t i = 0; i < 1024; i++)
        assert_int_equal(cell_of(s, AT + 4 * i)->of[RACE_HANDLER_WRITE].epoch, i < 2 || i >= 1002 ? 7 : 0);
    race_shadow_forget(s, AT + 5, 1);
    assert_int_equal(cell_of(s, AT + 4)->of[RACE_HANDLER_WRITE].epoch, 0);
    assert_int_equal(cell_of(s, AT)->of[RACE_HANDLER_WRITE].epoch, 7);
}

static void forgetting_makes_no_pages(void **state)
{
    struct race_shadow *s = *state;
    size_t before = race_shadow_bytes(s);
    race_shadow_forget(s, AT, 1 << 20);
    assert_null(race_shadow_quick(s, AT));
    assert_int_equal(race_shadow_bytes(s), before);
}

static void a_cleared_shadow_is_empty(void **state)
{
    struct race_shadow *s = *state;
    cell_of(s, AT)->of[RACE_MAIN_READ].epoch = 1;
    race_shadow_clear(s);
    assert_null(race_shadow_quick(s, AT));
    assert_int_equal(cell_of(s, AT)->of[RACE_MAIN_READ].epoch, 0);
}

static void an_access_is_one_word(void **state)
{
    (void)state;
    union {
        uint64_t word;
        struct race_access as;
    } x = {.word = UINT64_C(5) | UINT64_C(1) << RACE_VOLATILE_BIT},
      y = {.word = UINT64_C(2) << RACE_VOLATILE_BIT};
    assert_int_equal(x.as.epoch, 5);
    assert_true(x.as.is_volatile && !x.as.excused && !x.as.bytes && !x.as.place);
    assert_true(y.as.excused && !y.as.is_volatile);
}

static int begin(void **state)
{
    *state = race_shadow_new();
    return 0;
}

static int end(void **state)
{
    race_shadow_free(*state);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(each_word_has_a_cell, begin, end),
        cmocka_unit_test_setup_teardown(cells_stay_when_there_are_many, begin, end),
        cmocka_unit_test_setup_teardown(forgetting_takes_the_words_that_are_named, begin, end),
        cmocka_unit_test_setup_teardown(forgetting_ends_the_stretches_of_the_page, begin, end),
        cmocka_unit_test_setup_teardown(forgetting_makes_no_pages, begin, end),
        cmocka_unit_test(an_access_is_one_word),
        cmocka_unit_test_setup_teardown(a_cleared_shadow_is_empty, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
