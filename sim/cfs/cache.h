/* prefetch.h - the block cache of an I/O node.
 *
 *             take                 disk                      write
 *   (idle) ---------> RESERVED  READING ------> CLEAN (idle) ------> DIRTY ------> WRITING ------> CLEAN (idle)
 *                                                                            disk
 * A block that is idle (CLEAN, or never used, and not held) may be taken for another; the one idle for longest goes
 * first. All others stay.
 */
#ifndef CFS_CACHE_H
#define CFS_CACHE_H
#include <stdbool.h>
#include <stdint.h>

struct cache;
struct io_request;

enum cache_state { CACHE_UNUSED, CACHE_RESERVED, CACHE_READING, CACHE_CLEAN, CACHE_DIRTY, CACHE_WRITING };

struct cache_block {
    uint32_t file;
    uint64_t number;
    enum cache_state state;
    uint32_t holds;                            /* writes on their way to it */
    bool dirty_again;                          /* written while READING or WRITING */
    struct io_request *waiting, **waiting_end; /* while READING */
    struct cache_block *older, *newer;         /* idle */
    struct cache_block *chain;                 /* hash */
    bool idle;
};

struct cache *cache_new(uint64_t blocks);
void cache_free(struct cache *c);
/* NULL: not there. */
struct cache_block *cache_find(struct cache *c, uint32_t file, uint64_t number);
/* The block idle for longest becomes this one, RESERVED. NULL: none is idle. It must not be there already. */
struct cache_block *cache_take(struct cache *c, uint32_t file, uint64_t number);
/* To be called after a change of state or holds, and on use: keeps the idle list, used last is taken last. */
void cache_touch(struct cache *c, struct cache_block *b);
uint64_t cache_idle(const struct cache *c);
#endif
