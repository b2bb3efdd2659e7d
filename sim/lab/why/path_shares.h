/* path_shares.h - what has which share in the critical path. */
#ifndef LAB_WHY_PATH_SHARES_H
#define LAB_WHY_PATH_SHARES_H
#include "lab/why/why.h"

/* Sets by_class and shares of w. */
void path_shares_find(struct why *w);
#endif
