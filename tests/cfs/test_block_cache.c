/* The block cache: the least recently used block is evicted first; dirty and held blocks stay. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include "cfs/block_cache.h"

static struct cache_block *clean(struct cache *c, uint64_t number)
{
    struct cache_block *b = cache_take(c, 1, number);
    if (b) {
        b->state = CACHE_CLEAN;
        cache_touch(c, b);
    }
    return b;
}

static void a_block_taken_is_found_by_file_and_number(void **state)
{
    struct cache *c = cache_new(4);
    (void)state;
    assert_null(cache_find(c, 1, 7));
    struct cache_block *b = cache_take(c, 1, 7);
    assert_int_equal(b->state, CACHE_RESERVED);
    assert_ptr_equal(cache_find(c, 1, 7), b);
    assert_null(cache_find(c, 2, 7));
    assert_null(cache_find(c, 1, 8));
    cache_free(c);
}

static void the_block_idle_for_longest_is_taken(void **state)
{
    struct cache *c = cache_new(3);
    (void)state;
    for (uint64_t i = 0; i < 3; i++)
        clean(c, i);
    cache_touch(c, cache_find(c, 1, 0)); /* used: now 1 is the oldest */
    clean(c, 3);
    assert_non_null(cache_find(c, 1, 0));
    assert_null(cache_find(c, 1, 1));
    assert_non_null(cache_find(c, 1, 2));
    cache_free(c);
}

static void only_clean_blocks_that_nobody_holds_are_taken(void **state)
{
    struct cache *c = cache_new(3);
    (void)state;
    struct cache_block *dirty = clean(c, 0), *held = clean(c, 1), *reserved = cache_take(c, 1, 2);
    dirty->state = CACHE_DIRTY;
    cache_touch(c, dirty);
    held->holds = 1;
    cache_touch(c, held);
    assert_non_null(reserved);
    assert_int_equal(cache_idle(c), 0);
    assert_null(cache_take(c, 1, 3));
    dirty->state = CACHE_CLEAN;
    cache_touch(c, dirty);
    assert_ptr_equal(cache_take(c, 1, 3), dirty);
    assert_null(cache_find(c, 1, 0));
    cache_free(c);
}

static void it_finds_its_way_in_a_crowd(void **state)
{
    struct cache *c = cache_new(100);
    (void)state;
    for (uint64_t i = 0; i < 1000; i++)
        clean(c, i * 10);
    for (uint64_t i = 0; i < 1000; i++)
        assert_int_equal(cache_find(c, 1, i * 10) != NULL, i >= 900);
    cache_free(c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_block_taken_is_found_by_file_and_number),
        cmocka_unit_test(the_block_idle_for_longest_is_taken),
        cmocka_unit_test(only_clean_blocks_that_nobody_holds_are_taken),
        cmocka_unit_test(it_finds_its_way_in_a_crowd),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
