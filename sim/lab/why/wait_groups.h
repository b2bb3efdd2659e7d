/* wait_groups.h - waits that are alike. */
#ifndef LAB_WHY_WAIT_GROUPS_H
#define LAB_WHY_WAIT_GROUPS_H
#include "lab/why/why.h"

/* Sets the groups of w. */
void wait_groups_find(struct why *w);
#endif
