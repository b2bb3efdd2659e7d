/* block_cache.h - the block cache of an I/O node.
 *
 *            take                disk                    write                  disk
 *   (idle) --------> RESERVED  READING -----> CLEAN (idle) -----> DIRTY --> WRITING -----> CLEAN (idle)
 *
 * An idle block (CLEAN or never used, and not held) may be taken for other data; the block that has been idle
 * for longest is taken first. All other blocks stay.
 */
#ifndef CFS_BLOCK_CACHE_H
#define CFS_BLOCK_CACHE_H
#include <stdbool.h>
#include <stdint.h>

struct cache;
struct io_request;

enum cache_state { CACHE_RESERVED, CACHE_READING, CACHE_CLEAN, CACHE_DIRTY, CACHE_WRITING };

struct cache_block {
    uint32_t file;
    uint64_t number;
    enum cache_state state;
    uint32_t holds;                            /* writes whose data are on their way to the block */
    bool dirty_again;                          /* written while READING or WRITING */
    struct io_request *waiting, **waiting_end; /* while READING */
    struct cache_block *older, *newer;         /* idle */
    struct cache_block *chain;                 /* hash */
    bool idle;
};

struct cache *cache_new(uint64_t blocks);
void cache_free(struct cache *c);
/* Returns the block with that number of that file. NULL: it is not in the cache. */
struct cache_block *cache_find(struct cache *c, uint32_t file, uint64_t number);
/* The block that has been idle for longest becomes this one, RESERVED. NULL: none is idle. The block must not
 * be in the cache already. */
struct cache_block *cache_take(struct cache *c, uint32_t file, uint64_t number);
/* Keeps the list of idle blocks, on which the block used last is taken last: call it after a change of state
 * or holds, and on use. */
void cache_touch(struct cache *c, struct cache_block *b);
uint64_t cache_idle(const struct cache *c);
#endif
