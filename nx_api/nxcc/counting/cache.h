/* cache.h - simulates a data cache, and a translation buffer behind it, while the program runs: for cpu files
 * with the groups `cache` and `tlb`.
 *
 * Before a statement that loads or stores, inline assembly compares the address with the most recently used
 * line of the address's set, which takes five instructions. Out of line, it looks for the address in the rest
 * of the set, keeps the lines of a set in the order of their use (cache_runtime.c), and charges a miss to the
 * counter. Rules:
 *
 *   - A load that misses brings its line in, in place of the least recently used line; a store that misses
 *     does not. A line that has been stored to is written back when it is replaced.
 *   - A miss needs the translation of its page: a look-up in the translation buffer, of the same kind.
 *   - Within a block, between calls, an address that has been loaded is not looked up again; nor is a load
 *     that lies between two others less than a line apart. Where a load is followed by a store to its
 *     address, the line counts as stored to from the load on.
 *
 * By these rules the simulation is exact for the program's own loads and stores, as GCC leaves them. Library
 * calls of known cost use no cache.
 */
#ifndef NXCC_CACHE_H
#define NXCC_CACHE_H
#include "base/table.h"

/* The cache to simulate, or none. To be called once, before the others. */
void cache_use(const cache_costs &cache);
/* Do costs depend on addresses? */
bool cache_is_simulated();
/* Nothing has been loaded: a block begins, or a call has ended. */
void cache_forget();
/* Inserts the look-ups for stmt before it. They charge misses to left, a register. If left is NULL, the
 * values to charge, in units, are appended to units. */
void cache_look_up(gimple *stmt, tree left, vec<tree> &units);
/* The units that the look-ups for stmt can cost at most. */
int64_t cache_most(gimple *stmt);
#endif
