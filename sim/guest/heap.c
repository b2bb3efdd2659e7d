/* heap.c - malloc for one node: see heap.h.
 *
 * Blocks lie without gaps from base to top. Each begins with a head of 16 bytes, followed by the program's
 * bytes:
 *
 *     base                                                                         top
 *     | units prev tag rest | program's bytes, rest | units prev tag | free: links | ... |       not in use
 *
 * units is the block's size in HEAD bytes, head included; prev is that of the block before, so that both
 * neighbours can be found. tag tells used blocks, free blocks and foreign pointers apart. The last `rest`
 * bytes of a used block are more than the program has asked for; they are filled with REST, so that a write
 * past the end is noticed.
 * Invariants: no two free blocks are neighbours, and the block below top is in use; top - base is what the
 * heap takes of the node's memory.
 *
 * Free blocks are kept in bins: one bin for each size below 512 bytes, then one for each power of two. A
 * request takes the best block of its own bin, otherwise the first of the next bin that is not empty,
 * otherwise moves top.
 *
 * What the break has given is a block, too, with a tag of its own: free() does not know it. The break is the
 * end of that block if it lies below top, otherwise where the bytes of a new block would begin. */
#include <assert.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "guest/heap.h"

#define HEAD 16u
#define LEAST 32u /* a head and two links */
#define EXACT_BINS 32u
#define BINS 64u
#define TAG_USED 0xa110ca7eu
#define TAG_FREE 0x0f4eeb10u
#define TAG_BREAK 0xb4ea4b10u
#define REST 0xe5

struct block {
    uint32_t units, prev, tag, rest;
    struct block *next_free, *prev_free; /* of a free block; the program's bytes begin here */
};

struct node_heap {
    char *base, *top;
    size_t limit;
    size_t last;         /* size of the block below top; 0: no block */
    uint64_t filled;     /* bit b: bins[b] is not empty */
    struct block **bins; /* NULL: none has had a block yet */
    int (*room)(void *ctx, size_t bytes);
    void (*grown)(void *ctx, size_t used);
    void *ctx;
};

struct node_heap *node_heap_new(void *base, size_t limit, int (*room)(void *ctx, size_t bytes),
                                void (*grown)(void *ctx, size_t used), void *ctx)
{
    assert((uintptr_t)base % HEAD == 0 && limit <= (size_t)UINT32_MAX * HEAD);
    struct node_heap *h = xcalloc(1, sizeof *h);
    h->base = h->top = base;
    h->limit = limit;
    h->room = room;
    h->grown = grown;
    h->ctx = ctx;
    return h;
}

void node_heap_free(struct node_heap *h)
{
    free(h->bins);
    free(h);
}

size_t node_heap_used(const struct node_heap *h)
{
    return (size_t)(h->top - h->base);
}

/* The tag depends on the address, so that a copied head is no valid head. */
static uint32_t tag_at(const struct block *b, uint32_t kind)
{
    return kind ^ (uint32_t)((uintptr_t)b >> 4);
}
static bool is_free(const struct block *b)
{
    return b->tag == tag_at(b, TAG_FREE);
}
static bool is_in_use(const struct block *b)
{
    return b->tag == tag_at(b, TAG_USED) || b->tag == tag_at(b, TAG_BREAK);
}
static size_t size_of(const struct block *b)
{
    return (size_t)b->units * HEAD;
}
static size_t asked_of(const struct block *b)
{
    return size_of(b) - HEAD - b->rest;
}
static struct block *after(const struct block *b)
{
    return (struct block *)((char *)b + size_of(b));
}
static struct block *before(const struct block *b)
{
    return (struct block *)((char *)b - (size_t)b->prev * HEAD);
}

static unsigned bin_of(size_t size)
{
    size_t exact = size / HEAD;
    return exact < EXACT_BINS ? (unsigned)exact : EXACT_BINS + (unsigned)(63 - __builtin_clzll(size)) - 9;
}

static void put_in_bin(struct node_heap *h, struct block *b)
{
    unsigned i = bin_of(size_of(b));
    if (h->bins == NULL)
        h->bins = xcalloc(BINS, sizeof *h->bins);
    b->tag = tag_at(b, TAG_FREE);
    b->prev_free = NULL;
    b->next_free = h->bins[i];
    if (b->next_free != NULL)
        b->next_free->prev_free = b;
    h->bins[i] = b;
    h->filled |= UINT64_C(1) << i;
}

static void take_from_bin(struct node_heap *h, struct block *b)
{
    unsigned i = bin_of(size_of(b));
    if (b->next_free != NULL)
        b->next_free->prev_free = b->prev_free;
    if (b->prev_free != NULL)
        b->prev_free->next_free = b->next_free;
    else if ((h->bins[i] = b->next_free) == NULL)
        h->filled &= ~(UINT64_C(1) << i);
    b->tag = 0;
}

/* --- detection of writes past a block's end --- */

static unsigned char *bytes_of(struct block *b)
{
    return (unsigned char *)b + HEAD;
}

/* Notes that the program has asked for so many bytes of a block. */
static void set_asked(struct block *b, size_t asked)
{
    assert(asked <= size_of(b) - HEAD);
    b->rest = (uint32_t)(size_of(b) - HEAD - asked);
    memset(bytes_of(b) + asked, REST, b->rest);
}

static bool is_within(const struct block *b)
{
    const unsigned char *end = (const unsigned char *)after(b);
    if (b->rest > size_of(b) - HEAD)
        return false;
    for (const unsigned char *rest = end - b->rest; rest < end; rest++)
        if (*rest != REST)
            return false;
    return true;
}

/* A free block of at least size bytes, the best of its bin; NULL if there is none. */
static struct block *find_free(const struct node_heap *h, size_t size)
{
    unsigned i = bin_of(size);
    struct block *best = NULL;
    if (h->filled == 0)
        return NULL;
    for (struct block *b = h->bins[i]; b != NULL && (best == NULL || size_of(best) != size); b = b->next_free)
        if (size_of(b) >= size && (best == NULL || b->units < best->units))
            best = b;
    uint64_t larger = h->filled & ~((UINT64_C(2) << i) - 1);
    if (best == NULL && larger != 0)
        best = h->bins[__builtin_ctzll(larger)];
    return best;
}

/* Sets a block's size, also in the block above it, or in the heap if the block is the last. */
static void set_size(struct node_heap *h, struct block *b, size_t size)
{
    b->units = (uint32_t)(size / HEAD);
    if ((char *)b + size == h->top)
        h->last = size;
    else
        after(b)->prev = b->units;
}

/* Moves top up to end; returns false if the node's memory does not allow it. */
static bool raise_top(struct node_heap *h, char *end)
{
    size_t bytes = (size_t)(end - h->base);
    if (bytes > h->limit || !h->room(h->ctx, bytes))
        return false;
    h->top = end;
    h->grown(h->ctx, node_heap_used(h));
    return true;
}

/* Frees a block that is in no bin: merges it with free neighbours, and lowers top if it was the last block.
 */
static void give_back(struct node_heap *h, struct block *b)
{
    size_t size = size_of(b);
    if ((char *)after(b) != h->top && is_free(after(b))) {
        take_from_bin(h, after(b));
        size += size_of(after(b));
    }
    b->tag = 0;
    if (b->prev != 0 && is_free(before(b))) {
        b = before(b);
        take_from_bin(h, b);
        size += size_of(b);
    }
    if ((char *)b + size == h->top) {
        h->top = (char *)b;
        h->last = (size_t)b->prev * HEAD;
        h->grown(h->ctx, node_heap_used(h));
    } else {
        set_size(h, b, size);
        put_in_bin(h, b);
    }
}

/* Shortens a used block to size if the rest is large enough for a block. */
static void trim(struct node_heap *h, struct block *b, size_t size)
{
    if (size_of(b) - size < LEAST)
        return;
    struct block *rest = (struct block *)((char *)b + size);
    set_size(h, rest, size_of(b) - size);
    set_size(h, b, size);
    give_back(h, rest);
}

/* The size of the block for a request; 0 if no heap could hold it. */
static size_t block_size(const struct node_heap *h, size_t bytes)
{
    if (bytes > h->limit)
        return 0;
    size_t size = (bytes + HEAD + HEAD - 1) / HEAD * HEAD;
    return size < LEAST ? LEAST : size;
}

/* Makes a block above top; NULL if there is no room. */
static struct block *add_block(struct node_heap *h, size_t size, uint32_t kind)
{
    struct block *b = (struct block *)h->top;
    if (!raise_top(h, h->top + size))
        return NULL;
    b->prev = (uint32_t)(h->last / HEAD);
    b->tag = tag_at(b, kind);
    set_size(h, b, size);
    return b;
}

void *node_heap_alloc(struct node_heap *h, size_t bytes)
{
    size_t size = block_size(h, bytes);
    if (size == 0)
        return NULL;
    struct block *b = find_free(h, size);
    if (b != NULL) {
        take_from_bin(h, b);
        b->tag = tag_at(b, TAG_USED);
        trim(h, b, size);
        set_asked(b, bytes);
    } else {
        b = add_block(h, size, TAG_USED);
        if (b == NULL)
            return NULL;
        set_asked(b, bytes);
    }
    return (char *)b + HEAD;
}

/* Allocates a block that contains an aligned address with enough room, and frees what lies before and
 * behind. */
void *node_heap_alloc_aligned(struct node_heap *h, size_t align, size_t bytes)
{
    assert(align && !(align & (align - 1)));
    if (align <= HEAD || align > h->limit || bytes > h->limit)
        return node_heap_alloc(h, align <= HEAD ? bytes : SIZE_MAX);
    char *p = node_heap_alloc(h, bytes + align + LEAST);
    if (p == NULL)
        return NULL;
    struct block *b = (struct block *)(p - HEAD);
    size_t front = -(uintptr_t)p & (align - 1);
    if (front > 0 && front < LEAST)
        front += align;
    if (front > 0) {
        struct block *aligned = (struct block *)((char *)b + front);
        aligned->tag = tag_at(aligned, TAG_USED);
        set_size(h, aligned, size_of(b) - front);
        set_size(h, b, front);
        give_back(h, b);
        b = aligned;
    }
    trim(h, b, block_size(h, bytes));
    set_asked(b, bytes);
    return bytes_of(b);
}

/* The used block of a pointer that the program passed; NULL if there is no such block or it is damaged. */
static struct block *block_of(const struct node_heap *h, const void *p)
{
    uintptr_t at = (uintptr_t)p - (uintptr_t)h->base;
    if (at % HEAD != 0 || at < HEAD || at >= node_heap_used(h))
        return NULL;
    struct block *b = (struct block *)((char *)p - HEAD);
    if (b->tag != tag_at(b, TAG_USED) || size_of(b) > (size_t)(h->top - (char *)b) || size_of(b) < LEAST)
        return NULL;
    /* both neighbours agree: no write has reached either head */
    if ((char *)after(b) == h->top ? h->last != size_of(b) : after(b)->prev != b->units)
        return NULL;
    if (!is_within(b))
        return NULL;
    return b->prev == 0 || ((size_t)b->prev * HEAD <= at - HEAD && before(b)->units == b->prev) ? b : NULL;
}

/* Is the head of a block valid? */
static bool has_head(const struct node_heap *h, const struct block *b, uint32_t prev)
{
    size_t room = (size_t)(h->top - (const char *)b);
    return (is_in_use(b) || is_free(b)) && b->prev == prev && size_of(b) >= LEAST && size_of(b) <= room;
}

size_t node_heap_check(const struct node_heap *h, const void **block)
{
    uint32_t prev = 0;
    const struct block *last = NULL;
    for (const struct block *b = (const struct block *)h->base; (const char *)b < h->top;
         last = b, prev = b->units, b = after(b)) {
        bool good = has_head(h, b, prev);
        if (good && (is_free(b) || is_within(b)))
            continue;
        /* a damaged head was overrun from the block before */
        const struct block *culprit = good || !last ? b : last;
        *block = (const char *)culprit + HEAD;
        size_t most = size_of(culprit) - HEAD;
        return is_free(culprit) || culprit->rest > most ? most : asked_of(culprit);
    }
    *block = NULL;
    return 0;
}

size_t node_heap_in_use(const struct node_heap *h, size_t *free_blocks)
{
    size_t bytes = 0;
    *free_blocks = 0;
    for (const struct block *b = (const struct block *)h->base; (const char *)b < h->top; b = after(b))
        if (is_in_use(b))
            bytes += size_of(b);
        else if (is_free(b))
            ++*free_blocks;
        else
            break; /* a block has been written past its end: the program's next free() reports it */
    return bytes;
}

bool node_heap_owns(const struct node_heap *h, const void *p)
{
    return block_of(h, p) != NULL;
}

size_t node_heap_bytes(const struct node_heap *h, const void *p)
{
    const struct block *b = block_of(h, p);
    return b ? asked_of(b) : 0;
}

int node_heap_release(struct node_heap *h, void *p)
{
    struct block *b = block_of(h, p);
    if (b == NULL)
        return -1;
    give_back(h, b);
    return 0;
}

/* Extends a used block to size, into a free neighbour or past top. */
static bool widen(struct node_heap *h, struct block *b, size_t size)
{
    if ((char *)after(b) == h->top) {
        if (!raise_top(h, (char *)b + size))
            return false;
        set_size(h, b, size);
        return true;
    }
    struct block *next = after(b);
    if (!is_free(next) || size_of(b) + size_of(next) < size)
        return false;
    take_from_bin(h, next);
    set_size(h, b, size_of(b) + size_of(next));
    trim(h, b, size);
    return true;
}

void *node_heap_resize(struct node_heap *h, void *p, size_t bytes)
{
    struct block *b = block_of(h, p);
    size_t size = block_size(h, bytes);
    if (b == NULL || size == 0)
        return NULL;
    if (size <= size_of(b) || widen(h, b, size)) {
        trim(h, b, size);
        set_asked(b, bytes);
        return p;
    }
    void *q = node_heap_alloc(h, bytes);
    if (q != NULL) {
        memcpy(q, p, asked_of(b));
        give_back(h, b);
    }
    return q;
}

/* --- the break --- */

/* The block whose end is the break; NULL: the block below top is another's. */
static struct block *break_block(const struct node_heap *h)
{
    struct block *b = (struct block *)(h->top - h->last);
    return h->last != 0 && b->tag == tag_at(b, TAG_BREAK) ? b : NULL;
}

void *node_heap_break(const struct node_heap *h)
{
    struct block *b = break_block(h);
    return b ? bytes_of(b) + asked_of(b) : (unsigned char *)h->top + HEAD;
}

bool node_heap_move_break(struct node_heap *h, ptrdiff_t by)
{
    struct block *b = break_block(h);
    size_t before = b ? asked_of(b) : 0;
    if (by < 0 && (size_t)-by > before)
        return false;
    size_t size = block_size(h, before + (size_t)by);
    if (by == 0 || size == 0)
        return by == 0;
    if (b == NULL ? (b = add_block(h, size, TAG_BREAK)) == NULL : size > size_of(b) && !widen(h, b, size))
        return false;
    trim(h, b, size);
    if (by > 0)
        memset(bytes_of(b) + before, 0, (size_t)by);
    set_asked(b, before + (size_t)by);
    return true;
}
