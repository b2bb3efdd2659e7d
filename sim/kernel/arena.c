/* arena.c - see arena.h. */
#include "kernel/arena.h"
#include <stdbool.h>
#include <stdlib.h>
#include <sys/mman.h>
#include "kernel/prefetch.h"
#include "kernel/xalloc.h"

#if defined(__SANITIZE_ADDRESS__)

/* A block; they are linked. */
struct arena_chunk {
    struct arena_chunk *next, **link;
    _Alignas(CACHE_BLOCK) char block[];
};

void *arena_take(struct arena *p)
{
    void *memory = xaligned(CACHE_BLOCK, sizeof(struct arena_chunk) + p->bytes);
    struct arena_chunk *c = memory;
    *c = (struct arena_chunk){p->first, &p->first};
    if (c->next)
        c->next->link = &c->next;
    p->first = c;
    return c->block;
}

void arena_give(struct arena *p, void *block)
{
    struct arena_chunk *c = (struct arena_chunk *)((char *)block - offsetof(struct arena_chunk, block));
    (void)p;
    *c->link = c->next;
    if (c->next)
        c->next->link = c->link;
    free(c);
}

void arena_free(struct arena *p)
{
    while (p->first)
        arena_give(p, p->first->block);
}

#else

enum { CHUNK = 256 << 10, WORD = 64, WORDS = CHUNK / CACHE_PAIR / WORD };
enum { AHEAD = 4 }; /* a block is loaded so many before it is taken */

/* Behind the first few, chunks come in groups that fill a large page, if the system has any: then a TLB holds
 * them. */
enum { LARGE_PAGE = 2 << 20, GROUP = LARGE_PAGE / CHUNK, SINGLE = 4 };

/* At a multiple of its size, so that a block's chunk is found from its address. */
struct arena_chunk {
    uint32_t number;        /* in arena.chunks */
    uint32_t words;         /* bit W: unused[W] is not 0 */
    uint64_t unused[WORDS]; /* bit B of word W: block WORD * W + B */
    _Alignas(CACHE_BLOCK) char blocks[];
};

static bool begins_group(size_t chunk)
{
    return chunk < SINGLE || (chunk - SINGLE) % GROUP == 0;
}

static struct arena_chunk *new_chunk(const struct arena *p)
{
    if (!begins_group(p->count))
        return (struct arena_chunk *)((char *)p->chunks[p->count - 1] + CHUNK);
    if (p->count < SINGLE)
        return xchecked(aligned_alloc(CHUNK, CHUNK));
    struct arena_chunk *c = xchecked(aligned_alloc(LARGE_PAGE, LARGE_PAGE));
    madvise(c, LARGE_PAGE, MADV_HUGEPAGE);
    return c;
}

static void set_roomy(struct arena *p, const struct arena_chunk *c)
{
    p->roomy[c->number / WORD] |= UINT64_C(1) << c->number % WORD;
}

static void fill(const struct arena *p, struct arena_chunk *c)
{
    size_t blocks = (CHUNK - sizeof *c) / p->stride;
    for (size_t i = 0; i < blocks; i++) {
        c->unused[i / WORD] |= UINT64_C(1) << i % WORD;
        c->words |= UINT32_C(1) << i / WORD;
    }
}

/* There is no room in the others. */
static __attribute__((noinline)) void add_chunk(struct arena *p)
{
    p->stride = (p->bytes + CACHE_PAIR - 1) / CACHE_PAIR * CACHE_PAIR;
    p->a_block = (UINT64_C(1) << 32) / p->stride + 1;
    struct arena_chunk *c = new_chunk(p);
    *c = (struct arena_chunk){.number = (uint32_t)p->count};
    fill(p, c);
    if (p->count % WORD == 0) {
        p->chunks = xreallocarray(p->chunks, p->count + WORD, sizeof(struct arena_chunk *));
        p->roomy = xreallocarray(p->roomy, p->count / WORD + 1, sizeof *p->roomy);
        p->roomy[p->count / WORD] = 0;
    }
    p->chunks[p->count++] = p->first = c;
    set_roomy(p, c);
}

/* The first chunk is full. */
static __attribute__((noinline)) void leave_first(struct arena *p)
{
    size_t w = p->first->number / WORD, words = (p->count + WORD - 1) / WORD;
    p->roomy[w] &= p->roomy[w] - 1;
    while (w < words && !p->roomy[w])
        w++;
    p->first = w < words ? p->chunks[WORD * w + (size_t)__builtin_ctzll(p->roomy[w])] : NULL;
}

static void *take_first(struct arena *p)
{
    if (!p->first)
        add_chunk(p);
    struct arena_chunk *c = p->first;
    unsigned w = (unsigned)__builtin_ctz(c->words), b = (unsigned)__builtin_ctzll(c->unused[w]);
    c->unused[w] &= c->unused[w] - 1;
    if (!c->unused[w])
        c->words &= c->words - 1;
    if (!c->words)
        leave_first(p);
    char *block = c->blocks + (WORD * w + b) * p->stride, *ahead = block + AHEAD * p->stride;
    if (ahead < (char *)c + CHUNK)
        prefetch_pair(ahead);
    return block;
}

static void put_back(struct arena *p, void *block)
{
    struct arena_chunk *c = (struct arena_chunk *)((uintptr_t)block & ~(uintptr_t)(CHUNK - 1));
    uint64_t i = (uint64_t)((char *)block - c->blocks) * p->a_block >> 32;
    bool was_full = !c->words;
    c->unused[i / WORD] |= UINT64_C(1) << i % WORD;
    c->words |= UINT32_C(1) << i / WORD;
    if (!was_full)
        return;
    set_roomy(p, c);
    if (!p->first || c->number < p->first->number)
        p->first = c;
}

void *arena_take(struct arena *p)
{
    void *last = p->last;
    p->last = NULL;
    return last ? last : take_first(p);
}

void arena_give(struct arena *p, void *block)
{
    void *before = p->last;
    p->last = block;
    if (before)
        put_back(p, before);
}

void arena_free(struct arena *p)
{
    for (size_t i = p->count; i-- > 0;)
        if (begins_group(i))
            free(p->chunks[i]);
    free(p->chunks);
    free(p->roomy);
    *p = (struct arena){.bytes = p->bytes};
}

#endif
