/* deferral.h - what a node has yet to commit at moments for which the queue may have no event: its deferred
 * calls, and that it blocks lazily. (Deferred calls themselves are the operating system's: os/deferred.h.) */
#ifndef LP_DEFERRAL_H
#define LP_DEFERRAL_H
#include "lp/lp.h"

/* May the program, in a call at `now`, block lazily? As far as is known, it will be blocked there. No event
 * is queued for that: either something reaches the node before, or lp_apply_deferred blocks it. */
bool lp_may_block_lazily(const struct lp *lp, vtime now);
static inline void lp_block_lazily(struct lp *lp)
{
    lp_become(lp, LP_BLOCKS_LAZILY);
}
/* A lazily blocked program resumes at its commit time if what it waits for is there. Deferred calls that have
 * an event are committed first: messages may delay these, and the commit time with them. */
void lp_unblock_lazily(struct lp *lp);
/* Commits the deferred calls whose commit times come before a moment, and blocks a lazily blocked node if its
 * commit time does. Called before anything is done to the node that this could matter to. */
void lp_apply_deferred(struct lp *lp, struct instant before);
/* Puts an event into the queue for the first deferred call that needs one. */
void lp_schedule_deferred(struct lp *lp);
#endif
