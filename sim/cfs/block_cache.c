/* block_cache.c - see block_cache.h. The hash table finds blocks; nothing that is simulated depends on its
 * order. */
#include "cfs/block_cache.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

struct cache {
    struct cache_block *blocks;
    uint64_t fresh, count;               /* the first that was never taken, and of all */
    struct cache_block *oldest, *newest; /* idle, and taken before */
    uint64_t idle;
    struct cache_block **table;
    uint64_t mask;
};

static void put_idle(struct cache *c, struct cache_block *b)
{
    assert(!b->idle && b->holds == 0 && !b->waiting);
    b->idle = true;
    b->newer = NULL, b->older = c->newest;
    if (c->newest)
        c->newest->newer = b;
    else
        c->oldest = b;
    c->newest = b;
    c->idle++;
}

static void take_idle(struct cache *c, struct cache_block *b)
{
    b->idle = false;
    if (b->older)
        b->older->newer = b->newer;
    else
        c->oldest = b->newer;
    if (b->newer)
        b->newer->older = b->older;
    else
        c->newest = b->older;
    c->idle--;
}

struct cache *cache_new(uint64_t blocks)
{
    struct cache *c = xcalloc(1, sizeof *c);
    uint64_t size = 1;
    while (size < 2 * blocks)
        size *= 2;
    c->blocks = xmalloc(blocks * sizeof *c->blocks); /* not touched before they are used */
    c->count = blocks;
    c->table = xcalloc(size, sizeof *c->table);
    c->mask = size - 1;
    return c;
}

void cache_free(struct cache *c)
{
    if (!c)
        return;
    free(c->blocks);
    free(c->table);
    free(c);
}

static struct cache_block **slot(struct cache *c, uint32_t file, uint64_t number)
{
    uint64_t h = (number * UINT64_C(0x9e3779b97f4a7c15)) ^ (file * UINT64_C(0xc2b2ae3d27d4eb4f));
    return &c->table[(h ^ (h >> 31)) & c->mask];
}

struct cache_block *cache_find(struct cache *c, uint32_t file, uint64_t number)
{
    struct cache_block *b = *slot(c, file, number);
    while (b && (b->file != file || b->number != number))
        b = b->chain;
    return b;
}

static void forget(struct cache *c, struct cache_block *b)
{
    struct cache_block **link = slot(c, b->file, b->number);
    while (*link != b)
        link = &(*link)->chain;
    *link = b->chain;
}

struct cache_block *cache_take(struct cache *c, uint32_t file, uint64_t number)
{
    struct cache_block *b = c->fresh < c->count ? &c->blocks[c->fresh++] : c->oldest;
    assert(!cache_find(c, file, number));
    if (!b)
        return NULL;
    if (b == c->oldest)
        take_idle(c, b), forget(c, b);
    struct cache_block **link = slot(c, file, number);
    *b = (struct cache_block){.file = file, .number = number, .state = CACHE_RESERVED, .chain = *link};
    b->waiting_end = &b->waiting;
    *link = b;
    return b;
}

void cache_touch(struct cache *c, struct cache_block *b)
{
    if (b->idle)
        take_idle(c, b);
    if (b->state == CACHE_CLEAN && b->holds == 0)
        put_idle(c, b);
}

uint64_t cache_idle(const struct cache *c)
{
    return c->idle + c->count - c->fresh;
}
