/* pool.c - see pool.h. */
#include "kernel/pool.h"
#include <stdlib.h>
#include <sys/mman.h>
#include "kernel/cache.h"

#if defined(__SANITIZE_ADDRESS__)

void *pool_take(struct pool *p)
{
    void *block = malloc(p->bytes);
    if (!block)
        abort();
    return block;
}

void pool_give(struct pool *p, void *block)
{
    (void)p;
    free(block);
}

void pool_free(struct pool *p)
{
    (void)p;
}

#else

enum { FIRST = 64 }; /* blocks; each chunk has as many as all before */
enum { AHEAD = 4 };  /* a block is loaded so many before it is taken */

struct pool_chunk {
    struct pool_chunk *next;
    char blocks[] __attribute__((aligned(CACHE_BLOCK)));
};

/* Chunks of half its size and more are in large pages, if the system has any: then a TLB holds them. */
enum { LARGE_PAGE = 2 << 20 };

static void *checked(void *p)
{
    if (!p)
        abort();
    return p;
}

static struct pool_chunk *new_chunk(size_t bytes)
{
    if (bytes < LARGE_PAGE / 2)
        return checked(aligned_alloc(CACHE_BLOCK, bytes));
    bytes = (bytes + LARGE_PAGE - 1) / LARGE_PAGE * LARGE_PAGE;
    struct pool_chunk *c = checked(aligned_alloc(LARGE_PAGE, bytes));
    madvise(c, bytes, MADV_HUGEPAGE);
    return c;
}

static void add_chunk(struct pool *p)
{
    size_t stride = (p->bytes + CACHE_PAIR - 1) / CACHE_PAIR * CACHE_PAIR;
    size_t more = p->blocks ? p->blocks : FIRST;
    struct pool_chunk *c = new_chunk(sizeof *c + more * stride);
    c->next = p->chunks;
    p->chunks = c;
    p->blocks += more;
    p->unused = checked(reallocarray(p->unused, p->blocks, sizeof *p->unused));
    for (size_t i = more; i-- > 0;)
        pool_give(p, c->blocks + i * stride);
}

void *pool_take(struct pool *p)
{
    if (!p->count)
        add_chunk(p);
    void *block = p->unused[--p->count];
    if (p->count >= AHEAD)
        cache_load(p->unused[p->count - AHEAD]);
    return block;
}

void pool_give(struct pool *p, void *block)
{
    p->unused[p->count++] = block;
}

void pool_free(struct pool *p)
{
    for (struct pool_chunk *c = p->chunks, *next; c; c = next) {
        next = c->next;
        free(c);
    }
    free(p->unused);
    *p = (struct pool){.bytes = p->bytes};
}

#endif
