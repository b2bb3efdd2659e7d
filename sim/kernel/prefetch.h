/* prefetch.h - the processor's caches: what layout counts on, and loading ahead. A line is 64 bytes on all
 * x86; what is needed together lies in a pair of lines, at a multiple of CACHE_PAIR, or in a block of four:
 * loaded ahead, lines side by side hardly cost more than one (bench/speed/NOTES.md). */
#ifndef KERNEL_PREFETCH_H
#define KERNEL_PREFETCH_H
#include <stdint.h>

enum { CACHE_LINE = 64, CACHE_PAIR = 2 * CACHE_LINE, CACHE_BLOCK = 4 * CACHE_LINE };

/* Begins to load the pair of lines in which p lies, if it is not NULL: that it is no address, the processor
 * would have to find out from the page tables. (Inlined: GCC takes a function that only loads ahead for one
 * without effect, and drops its calls.) */
static inline __attribute__((always_inline)) void prefetch_pair(const void *p)
{
    if (!p)
        return;
    __builtin_prefetch(p, 1);
    __builtin_prefetch((const void *)((uintptr_t)p ^ CACHE_LINE), 1);
}

/* Begins to load the block in which p lies, if it is not NULL. */
static inline __attribute__((always_inline)) void prefetch_block(const void *p)
{
    if (!p)
        return;
    for (uintptr_t i = 0; i < CACHE_BLOCK; i += CACHE_LINE)
        __builtin_prefetch((const void *)((uintptr_t)p ^ i), 1);
}
#endif
