/* pool.c - see pool.h. */
#include "kernel/pool.h"
#include <stdlib.h>

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

enum { LINE = 64, PAIR = 2 * LINE, BLOCKS = 64 }; /* a cache's line, and two; blocks of a chunk */

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
    size_t stride = (p->bytes + PAIR - 1) / PAIR * PAIR; /* see evq.h */
    char *chunk = aligned_alloc(PAIR, PAIR + BLOCKS * stride);
    if (!chunk)
        abort();
    push(&p->chunks, chunk);
    for (size_t i = BLOCKS; i-- > 0;)
        push(&p->unused, chunk + PAIR + i * stride);
}

void *pool_take(struct pool *p)
{
    if (!p->unused)
        add_chunk(p);
    void *block = pop(&p->unused);
    for (size_t i = 0; i < PAIR; i += LINE)
        __builtin_prefetch((char *)p->unused + i, 1);
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
