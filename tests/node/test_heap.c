/* A node's heap: sim/guest/heap.h. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <cmocka.h>
#include "guest/heap.h"

#define LIMIT ((size_t)4 << 20)
#define SLOTS 500

struct fixture {
    char *base;
    struct node_heap *heap;
    size_t limit;
    size_t allowed; /* bytes that room() allows */
    size_t peak;    /* seen by grown() */
};

static int room(void *ctx, size_t bytes)
{
    const struct fixture *x = ctx;
    return bytes <= x->allowed;
}

static void grown(void *ctx, size_t used)
{
    struct fixture *x = ctx;
    x->peak = used > x->peak ? used : x->peak;
}

static int set_up_bytes(void **state, size_t limit)
{
    struct fixture *x = calloc(1, sizeof *x);
    x->base = mmap(NULL, limit, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    x->limit = x->allowed = limit;
    x->heap = node_heap_new(x->base, limit, room, grown, x);
    *state = x;
    return x->heap == NULL;
}

static int setup(void **state)
{
    return set_up_bytes(state, LIMIT);
}

static int set_up_large(void **state)
{
    return set_up_bytes(state, (size_t)32 << 30);
}

static int teardown(void **state)
{
    struct fixture *x = *state;
    node_heap_free(x->heap);
    munmap(x->base, x->limit);
    free(x);
    return 0;
}

static void blocks_are_aligned_and_apart(void **state)
{
    struct fixture *x = *state;
    char *a = node_heap_alloc(x->heap, 1), *b = node_heap_alloc(x->heap, 0),
         *c = node_heap_alloc(x->heap, 100);
    assert_int_equal((uintptr_t)a % 16 | (uintptr_t)b % 16 | (uintptr_t)c % 16, 0);
    assert_true(b >= a + 16 && c >= b + 16);
    assert_true(a >= x->base && c + 100 <= x->base + node_heap_used(x->heap));
}

static void all_given_back_means_nothing_used(void **state)
{
    struct fixture *x = *state;
    void *p[10];
    for (int i = 0; i < 10; i++)
        p[i] = node_heap_alloc(x->heap, 1000);
    size_t full = node_heap_used(x->heap);
    assert_int_equal(full, 10 * (1000 + 16 + 8)); /* head, rounded to 16 */
    for (int i = 0; i < 10; i += 2)
        assert_int_equal(node_heap_release(x->heap, p[i]), 0);
    assert_int_equal(node_heap_used(x->heap), full); /* the highest block is still there */
    for (int i = 1; i < 10; i += 2)
        assert_int_equal(node_heap_release(x->heap, p[i]), 0);
    assert_int_equal(node_heap_used(x->heap), 0);
    assert_int_equal(x->peak, full);
}

static void freed_neighbours_join(void **state)
{
    struct fixture *x = *state;
    void *a = node_heap_alloc(x->heap, 1000), *b = node_heap_alloc(x->heap, 1000);
    void *c = node_heap_alloc(x->heap, 1000), *end = node_heap_alloc(x->heap, 16);
    node_heap_release(x->heap, a);
    node_heap_release(x->heap, c);
    node_heap_release(x->heap, b);
    assert_ptr_equal(node_heap_alloc(x->heap, 3000), a);
    assert_int_equal(node_heap_release(x->heap, end), 0);
}

static void aligned_blocks_give_back_what_is_around_them(void **state)
{
    struct fixture *x = *state;
    void *p[100], *small[100];
    unsigned n = 0;
    for (size_t align = 1; align <= 8192; align *= 2)
        for (size_t bytes = 1; bytes < 5000; bytes = bytes * 9 + 3, n++) {
            small[n] = node_heap_alloc(x->heap, n % 4 * 16);
            p[n] = node_heap_alloc_aligned(x->heap, align, bytes);
            assert_int_equal((uintptr_t)p[n] % align, 0);
            memset(p[n], 1, bytes);
        }
    for (unsigned i = 0; i < n; i++)
        assert_int_equal(node_heap_release(x->heap, i % 2 ? small[i] : p[i]), 0);
    const void *bad;
    node_heap_check(x->heap, &bad);
    assert_null(bad);
    for (unsigned i = 0; i < n; i++)
        assert_int_equal(node_heap_release(x->heap, i % 2 ? p[i] : small[i]), 0);
    assert_int_equal(node_heap_used(x->heap), 0);
    assert_null(node_heap_alloc_aligned(x->heap, 16, SIZE_MAX - 100));
    assert_null(node_heap_alloc_aligned(x->heap, (size_t)1 << 62, 1));
}

static void memory_ends_where_room_says(void **state)
{
    struct fixture *x = *state;
    x->allowed = 10000;
    void *p = node_heap_alloc(x->heap, 9000);
    assert_non_null(p);
    assert_null(node_heap_alloc(x->heap, 1000));
    assert_null(node_heap_resize(x->heap, p, 11000));
    assert_true(node_heap_owns(x->heap, p));
    assert_non_null(node_heap_resize(x->heap, p, 9900));
    assert_int_equal(x->peak, 9920);
    x->allowed = SIZE_MAX;
    assert_null(node_heap_alloc(x->heap, LIMIT));
    assert_null(node_heap_alloc(x->heap, SIZE_MAX - 8));
    assert_int_equal(node_heap_used(x->heap), 9920);
}

static void resize_stays_in_place_when_it_can(void **state)
{
    struct fixture *x = *state;
    char *a = node_heap_alloc(x->heap, 100), *b = node_heap_alloc(x->heap, 1000);
    void *end = node_heap_alloc(x->heap, 16);
    memset(a, 7, 100);
    node_heap_release(x->heap, b);
    assert_ptr_equal(node_heap_resize(x->heap, a, 600), a); /* into the free neighbour */
    assert_ptr_equal(node_heap_resize(x->heap, a, 50), a);
    char *moved = node_heap_resize(x->heap, a, 5000);
    assert_true(moved > (char *)end);
    for (int i = 0; i < 50; i++)
        assert_int_equal(moved[i], 7);
}

/* Sizes and distances of more than 4 GB; only the blocks' ends are touched. */
static void blocks_may_be_larger_than_4_gb(void **state)
{
    struct fixture *x = *state;
    const size_t gb = (size_t)1 << 30, sizes[] = {5 * gb, 3 * gb, 9 * gb + 1, gb - 7};
    char *p[4];
    for (int i = 0; i < 4; i++) {
        p[i] = node_heap_alloc(x->heap, sizes[i]);
        assert_non_null(p[i]);
        p[i][0] = p[i][sizes[i] - 1] = (char)i;
        assert_int_equal(node_heap_bytes(x->heap, p[i]), sizes[i]);
    }
    assert_true(p[1] >= p[0] + sizes[0] && p[2] >= p[1] + sizes[1] && p[3] >= p[2] + sizes[2]);
    assert_null(node_heap_alloc(x->heap, 15 * gb));
    assert_int_equal(node_heap_release(x->heap, p[0]), 0);
    assert_int_equal(node_heap_release(x->heap, p[1]), 0);
    char *joined = node_heap_alloc(x->heap, 7 * gb);
    assert_ptr_equal(joined, p[0]);
    assert_ptr_equal(node_heap_resize(x->heap, joined, 8 * gb), joined);
    assert_int_equal(p[2][0] + p[2][sizes[2] - 1] + p[3][0] + p[3][sizes[3] - 1], 10);
    p[2][sizes[2]] = 1; /* one byte too far */
    assert_int_equal(node_heap_release(x->heap, p[2]), -1);
    const void *bad;
    assert_int_equal(node_heap_check(x->heap, &bad), sizes[2]);
    assert_ptr_equal(bad, p[2]);
}

static void foreign_and_damaged_pointers_are_refused(void **state)
{
    struct fixture *x = *state;
    char *a = node_heap_alloc(x->heap, 100), *b = node_heap_alloc(x->heap, 100);
    int elsewhere;
    assert_int_equal(node_heap_release(x->heap, &elsewhere), -1);
    assert_int_equal(node_heap_release(x->heap, x->base), -1);
    assert_int_equal(node_heap_release(x->heap, a + 1), -1);
    assert_int_equal(node_heap_release(x->heap, a + 16), -1);
    assert_int_equal(node_heap_release(x->heap, NULL), -1);
    memset(a, 1, 124); /* past its end, into b's head */
    assert_int_equal(node_heap_release(x->heap, a), -1);
    assert_int_equal(node_heap_release(x->heap, b), -1);
}

static void freed_twice_is_refused(void **state)
{
    struct fixture *x = *state;
    void *a = node_heap_alloc(x->heap, 100), *b = node_heap_alloc(x->heap, 100);
    assert_int_equal(node_heap_release(x->heap, a), 0);
    assert_int_equal(node_heap_release(x->heap, a), -1);
    assert_int_equal(node_heap_release(x->heap, b), 0);
    assert_int_equal(node_heap_release(x->heap, b), -1);
}

struct shadow {
    unsigned char *p;
    size_t bytes;
    unsigned char fill;
};

static size_t random_size(unsigned *seed)
{
    unsigned kind = rand_r(seed) % 10;
    return kind < 7 ? rand_r(seed) % 200 : kind < 9 ? rand_r(seed) % 3000 : rand_r(seed) % 60000;
}

static void check_contents(const struct shadow *s, size_t bytes)
{
    for (size_t k = 0; k < bytes; k++)
        assert_int_equal(s->p[k], s->fill);
}

/* Allocates, resizes and frees at random, and checks that contents stay. Returns a sum over all addresses. */
static uintptr_t random_calls(struct fixture *x, unsigned seed)
{
    struct shadow s[SLOTS] = {0};
    uintptr_t sum = 0;
    for (int i = 0; i < 30000; i++) {
        struct shadow *one = &s[rand_r(&seed) % SLOTS];
        size_t bytes = random_size(&seed);
        check_contents(one, one->bytes);
        if (one->p != NULL && rand_r(&seed) % 3 != 0) {
            assert_int_equal(node_heap_release(x->heap, one->p), 0);
            *one = (struct shadow){0};
            continue;
        }
        size_t kept = one->bytes < bytes ? one->bytes : bytes;
        unsigned char *q =
            one->p ? node_heap_resize(x->heap, one->p, bytes) : node_heap_alloc(x->heap, bytes);
        if (q == NULL)
            continue;
        one->p = q;
        check_contents(one, kept);
        one->bytes = bytes;
        one->fill = (unsigned char)i;
        memset(q, one->fill, bytes);
        sum = sum * 31 + (uintptr_t)(q - (unsigned char *)x->base);
    }
    for (int i = 0; i < SLOTS; i++) {
        check_contents(&s[i], s[i].bytes);
        assert_int_equal(s[i].p ? node_heap_release(x->heap, s[i].p) : 0, 0);
    }
    return sum;
}

static void random_calls_keep_contents_and_end_empty(void **state)
{
    struct fixture *x = *state;
    for (unsigned seed = 1; seed <= 10; seed++) {
        x->allowed = seed % 2 ? LIMIT : 200000; /* with and without refusals */
        random_calls(x, seed);
        assert_int_equal(node_heap_used(x->heap), 0);
    }
}

static void addresses_depend_on_the_calls_only(void **state)
{
    struct fixture *x = *state;
    uintptr_t first = random_calls(x, 42);
    void *other;
    setup(&other);
    assert_int_equal(random_calls(other, 42), first);
    assert_int_equal(random_calls(x, 42), first); /* addresses do not depend on blocks freed before */
    teardown(&other);
}

static void the_break_moves_without_gaps(void **state)
{
    struct fixture *x = *state;
    char *first = node_heap_break(x->heap), *used = memset(node_heap_alloc(x->heap, 100), 7, 100);
    char *begin = node_heap_break(x->heap);
    assert_true(begin > used + 100 && first < begin); /* blocks raise it */
    assert_true(node_heap_move_break(x->heap, 1000) && node_heap_move_break(x->heap, 5));
    assert_ptr_equal(node_heap_break(x->heap), begin + 1005);
    memset(begin, 9, 1005);
    assert_true(node_heap_move_break(x->heap, -1005) && node_heap_move_break(x->heap, 1005));
    for (int i = 0; i < 1005; i++)
        assert_int_equal(begin[i], 0);
    assert_false(node_heap_move_break(x->heap, -1006));
    x->allowed = node_heap_used(x->heap) + 100;
    assert_false(node_heap_move_break(x->heap, 200));
    assert_ptr_equal(node_heap_break(x->heap), begin + 1005);
}

static void what_the_break_gave_is_no_block_of_malloc(void **state)
{
    struct fixture *x = *state;
    char *begin = node_heap_break(x->heap);
    const void *damaged;
    size_t free_blocks;
    assert_true(node_heap_move_break(x->heap, 100));
    assert_int_equal(node_heap_release(x->heap, begin), -1);
    char *above = node_heap_alloc(x->heap, 50), *end = node_heap_break(x->heap);
    assert_true(end > above + 50);
    assert_true(node_heap_move_break(x->heap, 10)); /* a part of its own behind the block */
    assert_ptr_equal(node_heap_break(x->heap), end + 10);
    assert_int_equal(node_heap_check(x->heap, &damaged), 0);
    assert_null(damaged);
    assert_int_equal(node_heap_in_use(x->heap, &free_blocks), node_heap_used(x->heap));
    end[10] = 1;
    assert_int_equal(node_heap_check(x->heap, &damaged), 10);
    assert_ptr_equal(damaged, end);
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, setup, teardown)
    const struct CMUnitTest tests[] = {
        TEST(blocks_are_aligned_and_apart),
        TEST(all_given_back_means_nothing_used),
        TEST(aligned_blocks_give_back_what_is_around_them),
        TEST(freed_neighbours_join),
        TEST(memory_ends_where_room_says),
        TEST(resize_stays_in_place_when_it_can),
        cmocka_unit_test_setup_teardown(blocks_may_be_larger_than_4_gb, set_up_large, teardown),
        TEST(foreign_and_damaged_pointers_are_refused),
        TEST(freed_twice_is_refused),
        TEST(the_break_moves_without_gaps),
        TEST(what_the_break_gave_is_no_block_of_malloc),
        TEST(random_calls_keep_contents_and_end_empty),
        TEST(addresses_depend_on_the_calls_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
