/* pool.c - see pool.h. */
#include "kernel/pool.h"
#include <stdlib.h>
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

enum { BLOCKS = 64 }; /* of a chunk */

static void push(void **list, void *block)
{
    *(void **)block = *list;
    *list = block;
}

static void *pop(void **list)
{
    void *block = *list;
    *list = *(void **)block;
    return block;
}

static void add_chunk(struct pool *p)
{
    size_t stride = (p->bytes + CACHE_PAIR - 1) / CACHE_PAIR * CACHE_PAIR;
    char *chunk = aligned_alloc(CACHE_PAIR, CACHE_PAIR + BLOCKS * stride);
    if (!chunk)
        abort();
    push(&p->chunks, chunk);
    for (size_t i = BLOCKS; i-- > 0;)
        push(&p->unused, chunk + CACHE_PAIR + i * stride);
}

void *pool_take(struct pool *p)
{
    if (!p->unused)
        add_chunk(p);
    void *block = pop(&p->unused);
    cache_load(p->unused);
    return block;
}

void pool_give(struct pool *p, void *block)
{
    push(&p->unused, block);
}

void pool_free(struct pool *p)
{
    while (p->chunks)
        free(pop(&p->chunks));
    p->unused = NULL;
}

#endif
