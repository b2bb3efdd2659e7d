/* prefetch_coming.h - prefetches of what the nodes of coming events need: with thousands of nodes, none of
 * it is in the caches when its event comes. Loading begins some events ahead: the node first, then what it
 * points to. */
#ifndef LP_PREFETCH_COMING_H
#define LP_PREFETCH_COMING_H
#include "lp/schedule.h"

/* From so many nodes on loading ahead pays: the caches hold fewer. */
enum { PREFETCH_NODES = 400 };

/* A program is about to run. */
void prefetch_coming(struct schedule *s);
#endif
