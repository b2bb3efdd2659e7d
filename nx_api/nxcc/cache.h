/* cache.h - a data cache simulated while the program runs, for cpu files with a `cache` group.
 *
 * Before each statement that loads or stores, the program calls nxc_cache_load or nxc_cache_store (cache_runtime.c) with
 * the address, and pays what they answer. It is exact for the program's own loads and stores, as GCC leaves them, and
 * makes a program several times slower: for studies of what caches change, not for use every day.
 */
#ifndef NXCC_CACHE_H
#define NXCC_CACHE_H
#include "table.h"

/* The cache to simulate, or none; must be called once before the other. */
void cache_use(const cache_costs &cache);
/* Do costs depend on addresses? */
bool cache_is_simulated();
/* Inserts the look-ups for stmt before it, and appends the values, in units, that they answer. */
void cache_look_up(gimple *stmt, vec<tree> &units);
#endif
