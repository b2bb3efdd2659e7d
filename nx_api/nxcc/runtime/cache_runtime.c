/* cache_runtime.c - the state of a node program's simulated data cache and translation buffer (cache.h).
 * Linked only into programs that use it. The state is in the node's own memory; handlers find the lines that
 * their program has left.
 *
 * A set has room for the addresses of NXC_CACHE_WAYS lines or pages, the most recently used first. 0: empty.
 * A line that has been stored to since it was loaded has 1 added to its address.
 */
#include <stdint.h>
#include "../../contract/program_image.h"

struct set {
    uint64_t line[NXC_CACHE_WAYS];
};
_Static_assert(sizeof(struct set) == NXC_CACHE_SET_BYTES, "the code of cache.cc has another size");

/* The sets of the cache, those of the translation buffer, and room for the line that was looked at last. */
__attribute__((visibility("hidden"), aligned(64))) struct set nxc_cache[NXC_CACHE_SETS + NXC_TLB_SETS + 1];
