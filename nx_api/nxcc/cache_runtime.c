/* cache_runtime.c - the state of a node program's simulated data cache and translation buffer: see cache.h. Linked only into
 * programs that ask for it. It is in the node's own memory; handlers find the lines their program left.
 *
 * A set has room for NXC_CACHE_WAYS addresses of lines or pages, the last used first. 0: empty.
 */
#include <stdint.h>
#include "../contract/program_image.h"

struct set {
    uint64_t line[NXC_CACHE_WAYS];
};
_Static_assert(sizeof(struct set) == NXC_CACHE_SET_BYTES, "as the code that nxcc makes has it");

/* Of the cache, then of the translation buffer. */
__attribute__((visibility("hidden"), aligned(64))) struct set nxc_cache[NXC_CACHE_SETS + NXC_TLB_SETS];
