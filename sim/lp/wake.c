/* wake.c - see wake.h, and engine.h. */
#include "lp/wake.h"
#include "lp/block.h"
#include "lp/clock.h"
#include "lp/deferral.h"
#include "lp/dispatch.h"
#include "lp/engine.h"
#include "lp/run_program.h"
#include "lp/upcalls.h"

void lp_woken(void *ctx, void *arg, vtime now)
{
    struct lp *lp = ctx;
    (void)arg;
    lp_apply_deferred(lp, lp->schedule->reached);
    lp_unblock_lazily(lp);
    if (lp->state == LP_BLOCKED && lp_unblock(lp, now))
        lp_run_on(lp);
}

void lp_wake(struct lp *lp, vtime t)
{
    evq_put_late(lp->schedule->q, t, lp->address, lp_woken, lp, NULL);
}

inline void lp_notify(struct lp *lp, vtime t)
{
    lp_apply_deferred(lp, lp->schedule->reached);
    lp_unblock_lazily(lp);
    vtime commits =
        lp->state == LP_OFFLOADED ? lp->schedule->present.time + lp->clock.stolen : lp_commit_time(lp);
    if (lp->state == LP_BLOCKED || commits < t)
        lp_wake(lp, t);
    /* else the node, which has an event, asks at its commit time, not before t */
}

void lp_synchronise(struct lp *lp)
{
    if (lp->state != LP_PAUSED && lp->state != LP_BLOCKS_LAZILY && !up_has_deferred(lp))
        return;
    struct instant at = lp->schedule->reached;
    if (lp->state == LP_PAUSED)
        lp_catch_up(lp, at.time + (lp->address < at.address));
    lp_apply_deferred(lp, at);
}
