/* arena.h - blocks of memory of one size, which come and go often. Taken is the one given back last, which
 * the caches still hold, else of those that are unused the first by address: so the blocks in use lie close
 * together, and those taken one after the other side by side, in whatever order they were given back. With
 * AddressSanitizer each is the heap's own, so that it sees a use after the end. */
#ifndef KERNEL_ARENA_H
#define KERNEL_ARENA_H
#include <stddef.h>
#include <stdint.h>

struct arena_chunk; /* what blocks are cut from */

struct arena {
    size_t bytes;              /* of a block, at most 64 KB; the rest is the arena's own */
    void *last;                /* the block given back last. NULL: it has been taken */
    struct arena_chunk *first; /* with unused blocks. NULL: there is none */
    size_t stride;             /* from one block to the next */
    uint64_t a_block;          /* 2^32 / stride, rounded up */
    struct arena_chunk **chunks;
    uint64_t *roomy; /* bit B of word W: chunk 64 * W + B has unused blocks */
    size_t count;    /* of chunks */
};

/* At the beginning of a pair of lines (prefetch.h), or of a block if it has whole ones. Not cleared. Never
 * NULL. */
void *arena_take(struct arena *p);
/* Does not look at the block. */
void arena_give(struct arena *p, void *block);
/* All blocks go, in use or not. */
void arena_free(struct arena *p);
#endif
