/* pool.h - blocks of memory of one size, which come and go often: those given back last are used first, while the caches
 * still hold them. With AddressSanitizer each is the heap's own, so that it sees a use after the end. */
#ifndef POOL_POOL_H
#define POOL_POOL_H
#include <stddef.h>

struct pool_chunk; /* what blocks are cut from */

struct pool {
    size_t bytes;  /* of a block */
    void **unused; /* blocks: none of them is looked at, not even to find another, until it is taken */
    size_t count;  /* of them */
    size_t blocks; /* in all */
    struct pool_chunk *chunks;
};

/* At the beginning of a pair of lines (cache.h), or of a block if it has whole ones. Not cleared. Never NULL. */
void *pool_take(struct pool *p);
void pool_give(struct pool *p, void *block);
/* All blocks go, in use or not. */
void pool_free(struct pool *p);
#endif
