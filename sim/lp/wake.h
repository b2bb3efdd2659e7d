/* wake.h - something may have come for a node that waits, or may come for one that computes ahead. */
#ifndef LP_WAKE_H
#define LP_WAKE_H
#include "lp/lp.h"

/* An event (ctx: the node): a blocked node is asked whether it may resume. */
void lp_woken(void *ctx, void *arg, vtime now);
#endif
