/* prefetch_coming.h - with thousands of nodes, none of what a node needs is in the caches when its event
 * comes. Loading begins some events ahead: the node first, then what it points to. */
#ifndef LP_PREFETCH_COMING_H
#define LP_PREFETCH_COMING_H
#include "lp/schedule.h"

void prefetch_coming(const struct schedule *s);
#endif
