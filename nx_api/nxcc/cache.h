/* cache.h - a data cache, and a translation buffer behind it, simulated while the program runs: for cpu files with the groups
 * `cache` and `tlb`.
 *
 * Before a statement that loads or stores, inline assembly looks whether the address lies in the line that was used last of its
 * set, which takes five instructions; the way of all others is beside the code. It keeps the lines of a set in the order of
 * their use (cache_runtime.c), and takes what a miss costs off the counter. Rules:
 *
 *   - a load that misses brings its line in, in place of the one not used longest; a store that misses does not
 *   - a line that is not there needs its page's translation: a look into the translation buffer, of the same kind
 *   - within a block and between calls, what has been loaded is not looked up again, nor is a load at a place between two others
 *     that are less than a line apart
 *
 * Exact by these rules for the program's own loads and stores, as GCC leaves them. Library calls of known cost use no cache.
 */
#ifndef NXCC_CACHE_H
#define NXCC_CACHE_H
#include "table.h"

/* The cache to simulate, or none; must be called once before the others. */
void cache_use(const cache_costs &cache);
/* Do costs depend on addresses? */
bool cache_is_simulated();
/* A block begins, or a call is behind us: nothing has been loaded. */
void cache_forget();
/* Inserts the look-ups for stmt before it. They take what they cost off left, a register; where that is NULL, values, in units,
 * are appended to units. */
void cache_look_up(gimple *stmt, tree left, vec<tree> &units);
/* What the look-ups for stmt can cost at most. */
int64_t cache_most(gimple *stmt);
#endif
