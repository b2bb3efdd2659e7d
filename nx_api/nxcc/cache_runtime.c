/* cache_runtime.c - the simulated data cache of a node program: see cache.h. Linked only into programs that ask for it.
 *
 * Write-back, the least recently used line of a set is replaced, and a store that misses brings no line in, as on the
 * i860 XR. Tags are in the node's own memory; handlers find the lines their program left.
 */
#include <stdint.h>
#include "image.h"

long nxc_cache_load(const void *address, long sets, long ways, long line, long miss);
long nxc_cache_store(const void *address, long sets, long ways, long line, long miss);

/* A set's lines, the last used first. 0: empty. */
static uintptr_t lines[NXC_CACHE_LINES];

static long look_up(const void *address, long sets, long ways, long line, long miss, int bring)
{
    uintptr_t wanted = (uintptr_t)address / (uintptr_t)line;
    uintptr_t *set = lines + (wanted & (uintptr_t)(sets - 1)) * (uintptr_t)ways;
    long i = 0;
    while (i < ways && set[i] != wanted)
        i++;
    if (i == ways && !bring)
        return miss;
    long units = i == ways ? miss : 0;
    for (i = i == ways ? ways - 1 : i; i > 0; i--)
        set[i] = set[i - 1];
    set[0] = wanted;
    return units;
}

long nxc_cache_load(const void *address, long sets, long ways, long line, long miss)
{
    return look_up(address, sets, ways, line, miss, 1);
}

long nxc_cache_store(const void *address, long sets, long ways, long line, long miss)
{
    return look_up(address, sets, ways, line, miss, 0);
}
