/* Blocks of a pool are as new memory is: aligned, apart from each other, and to be had again when they have
 * been given back. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "kernel/prefetch.h"
#include "kernel/arena.h"

enum { BYTES = 168, MANY = 1000 };

static void fill(unsigned char *block, int i)
{
    memset(block, i % 251, BYTES);
}

/* Each is as it was filled; then all go. */
static void end_with(struct arena *p, unsigned char *blocks[MANY])
{
    for (int i = 0; i < MANY; i++)
        for (int k = 0; k < BYTES; k++)
            assert_int_equal(blocks[i][k], i % 251);
    for (int i = 0; i < MANY; i++)
        arena_give(p, blocks[i]);
    arena_free(p);
}

static void blocks_are_aligned_and_do_not_touch(void **state)
{
    struct arena p = {.bytes = BYTES};
    unsigned char *blocks[MANY];
    (void)state;
    for (int i = 0; i < MANY; i++) {
        blocks[i] = arena_take(&p);
        assert_int_equal((uintptr_t)blocks[i] % CACHE_PAIR, 0);
        fill(blocks[i], i);
    }
    end_with(&p, blocks);
}

/* Every other block goes and comes again, while the others stay as they are. */
static void given_blocks_are_taken_again(void **state)
{
    struct arena p = {.bytes = BYTES};
    unsigned char *blocks[MANY];
    (void)state;
    for (int i = 0; i < MANY; i++)
        fill(blocks[i] = arena_take(&p), i);
    for (int i = 0; i < MANY; i += 2)
        arena_give(&p, blocks[i]);
    for (int i = 0; i < MANY; i += 2)
        fill(blocks[i] = arena_take(&p), i);
    end_with(&p, blocks);
}

/* The one given back last, which the caches still hold. (The other is the first by address.) */
static void the_last_given_is_the_next_taken(void **state)
{
#if defined(__SANITIZE_ADDRESS__)
    (void)state;
    skip();
#else
    struct arena p = {.bytes = BYTES};
    void *a = arena_take(&p), *b = arena_take(&p);
    (void)state;
    arena_give(&p, a);
    arena_give(&p, b);
    assert_ptr_equal(arena_take(&p), b);
    assert_ptr_equal(arena_take(&p), a);
    arena_free(&p);
#endif
}

/* Behind that one the first by address, in whatever order they were given back: in more chunks than a group
 * has, and than have a word of bits. */
static void the_others_are_taken_by_address(void **state)
{
#if defined(__SANITIZE_ADDRESS__)
    (void)state;
    skip();
#else
    enum { CHUNKS = 70, LARGE = 60000, COUNT = CHUNKS * 4, STEP = 97 };
    struct arena p = {.bytes = LARGE};
    char *blocks[COUNT], *again[COUNT];
    (void)state;
    for (int i = 0; i < COUNT; i++)
        memset(blocks[i] = arena_take(&p), i, LARGE);
    for (int i = 0; i < COUNT; i++)
        assert_int_equal((unsigned char)blocks[i][LARGE - 1], i % 256);
    for (int i = 0; i < COUNT; i++)
        arena_give(&p, blocks[i * STEP % COUNT]);
    for (int i = 0; i < COUNT; i++)
        again[i] = arena_take(&p);
    int last = (COUNT - 1) * STEP % COUNT;
    assert_ptr_equal(again[0], blocks[last]);
    for (int i = 1; i < COUNT; i++)
        assert_ptr_equal(again[i], blocks[i <= last ? i - 1 : i]);
    arena_free(&p);
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blocks_are_aligned_and_do_not_touch),
        cmocka_unit_test(given_blocks_are_taken_again),
        cmocka_unit_test(the_last_given_is_the_next_taken),
        cmocka_unit_test(the_others_are_taken_by_address),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
