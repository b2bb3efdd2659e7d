/* asan_blocks.c - the heap of a checked program: see node_asan.h. */
#include <assert.h>
#include <stdlib.h>
#include "asan/node_asan.h"
#include "guest/heap.h"
#include "kernel/xalloc.h"
#include "node/self.h"
#include "nx_api/contract/backend.h"
#include "os/asan_hooks.h"

enum {
    FRONT = sizeof(struct asan_block),
    ALIGNED = 16,
    LEAST_ZONE = 16, /* behind a block; a large one has more, for accesses further on */
    MOST_ZONE = 2048,
    MARKED_AT_ONCE = 1 << 16,
    FREED_SHARE = 4,         /* so much of the space, at most, is kept from being given out again */
    MOST_BEFORE = 2 * FRONT, /* an access so far before a block is taken for one that missed it */
};
_Static_assert(FRONT % ALIGNED == 0, "the program's bytes are aligned behind the block's head");

/* The tag depends on the address, so that a copied head is no head. */
static uint64_t tag_of(const struct asan_block *b)
{
    return UINT64_C(0x6e78636173616e21) ^ (uintptr_t)b;
}

static struct asan_block *head_of(const void *bytes)
{
    return (struct asan_block *)(uintptr_t)bytes - 1;
}

/* --- giving --- */

static size_t zone_behind(size_t bytes)
{
    size_t zone = bytes / 4 / ALIGNED * ALIGNED;
    return zone < LEAST_ZONE ? LEAST_ZONE : zone > MOST_ZONE ? MOST_ZONE : zone;
}

/* Makes the oldest of the freed blocks memory that can be given out. */
static void release_oldest(struct node_asan *a)
{
    struct asan_block *b = a->freed[a->freed_first];
    a->freed_first = (a->freed_first + 1) % a->freed_room;
    a->freed_count--;
    a->freed_bytes -= FRONT + b->bytes;
    asan_shadow_mark(&a->shadow, asan_block_begin(b), b->bytes + LEAST_ZONE, NXC_ASAN_HEAP);
    b->tag = 0;
    node_heap_release(a->blocks, b->whole);
}

static void *find_room(struct node *n, size_t bytes)
{
    struct node_asan *a = n->asan;
    void *p;
    while (!(p = node_heap_alloc(a->blocks, bytes)) && a->freed_count)
        release_oldest(a);
    if (!p)
        node_fail(
            n,
            "--asan: with red zones the heap has no room for %zu bytes more; build with --asan only the "
            "files in question, or run a smaller case",
            bytes);
    return p;
}

/* Where the heap has never reached so far, nothing is the program's. */
static void mark_up_to(struct node *n, uintptr_t end)
{
    struct node_asan *a = n->asan;
    uintptr_t last = (uintptr_t)n->guest.heap_start + n->guest.region->heap_bytes;
    if (end <= a->marked)
        return;
    end = end + MARKED_AT_ONCE < last ? end + MARKED_AT_ONCE : last;
    asan_shadow_mark(&a->shadow, a->marked, end - a->marked, NXC_ASAN_HEAP);
    a->marked = end;
}

void *asan_give(struct node *n, void *counted, size_t align, size_t bytes, const void *frame)
{
    struct node_asan *a = n->asan;
    size_t more = align > ALIGNED ? align : 0, all = FRONT + more + bytes + zone_behind(bytes);
    char *whole = find_room(n, all);
    uintptr_t begin = (uintptr_t)whole + FRONT;
    if (more)
        begin = (begin + align - 1) & ~(uintptr_t)(align - 1);
    mark_up_to(n, (uintptr_t)whole + all);
    struct asan_block *b = head_of((void *)begin);
    *b = (struct asan_block){.tag = tag_of(b),
                             .whole = whole,
                             .counted = counted,
                             .bytes = bytes,
                             .allocated = asan_stacks_here(a->stacks, n, frame)};
    asan_shadow_open(&a->shadow, begin, bytes);
    return (void *)begin;
}

/* --- taking --- */

static bool is_of_heap(const struct node *n, uintptr_t at)
{
    return at - (uintptr_t)n->guest.heap_start < n->guest.region->heap_bytes;
}

static bool is_head(const struct node *n, const struct asan_block *b)
{
    return is_of_heap(n, (uintptr_t)b) && is_of_heap(n, (uintptr_t)(b + 1)) && b->tag == tag_of(b);
}

void *asan_counted(struct node *n, const char *call, const void *block, const void *frame)
{
    const struct asan_block *b = head_of(block);
    if ((uintptr_t)block % ALIGNED || !is_head(n, b) || !b->counted)
        asan_report_block(n, call, block, frame);
    return b->counted;
}

size_t asan_bytes(const void *block)
{
    return head_of(block)->bytes;
}

/* Appends to the ring. */
static void keep(struct node_asan *a, struct asan_block *b)
{
    if (a->freed_count == a->freed_room) {
        size_t room = a->freed_room ? 2 * a->freed_room : 64;
        struct asan_block **ring = xcalloc(room, sizeof(*ring));
        for (size_t i = 0; i < a->freed_count; i++)
            ring[i] = a->freed[(a->freed_first + i) % a->freed_room];
        free(a->freed);
        a->freed = ring, a->freed_first = 0, a->freed_room = room;
    }
    a->freed[(a->freed_first + a->freed_count++) % a->freed_room] = b;
    a->freed_bytes += FRONT + b->bytes;
}

void asan_take(struct node *n, void *block, const void *frame)
{
    struct node_asan *a = n->asan;
    struct asan_block *b = head_of(block);
    assert(is_head(n, b) && b->counted);
    b->counted = NULL;
    b->freed = asan_stacks_here(a->stacks, n, frame);
    asan_shadow_mark(&a->shadow, asan_block_begin(b), (b->bytes + ALIGNED - 1) / ALIGNED * ALIGNED,
                     NXC_ASAN_FREED);
    keep(a, b);
    while (a->freed_bytes > n->guest.region->heap_bytes / FREED_SHARE)
        release_oldest(a);
}

/* --- finding --- */

/* How far an address is from a block's bytes. */
static uintptr_t distance(const struct asan_block *b, uintptr_t at)
{
    uintptr_t begin = asan_block_begin(b), end = begin + b->bytes;
    return at < begin ? begin - at : at < end ? 0 : at - end + 1;
}

const struct asan_block *asan_block_near(const struct node *n, uintptr_t at)
{
    const struct asan_block *below = NULL, *above = NULL;
    uintptr_t here = at / ALIGNED * ALIGNED - FRONT, lowest = (uintptr_t)n->guest.heap_start;
    if (!is_of_heap(n, at))
        return NULL;
    for (uintptr_t i = here; !below && i >= lowest; i -= ALIGNED)
        below = is_head(n, (const struct asan_block *)i) ? (const struct asan_block *)i : NULL;
    for (uintptr_t i = here + ALIGNED; !above && i <= here + MOST_BEFORE; i += ALIGNED)
        above = is_head(n, (const struct asan_block *)i) ? (const struct asan_block *)i : NULL;
    return !above || (below && distance(below, at) <= distance(above, at)) ? below : above;
}
