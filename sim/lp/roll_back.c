/* roll_back.c - what a program has done ahead of a moment, and of what has not happened: lp/engine.h. */
#include "lp/block.h"
#include "lp/deferral.h"
#include "lp/dispatch.h"
#include "lp/engine.h"
#include "lp/offload.h"
#include "lp/upcalls.h"

bool lp_roll_back(struct lp *lp, struct instant at)
{
    offload_drop(lp);
    lp_apply_deferred(lp, instant_later(at, lp->schedule->reached));
    if (lp->state == LP_BLOCKS_LAZILY)
        lp_become(lp, LP_COMPUTING);
    up_roll_back_deferred(lp);
    lp_catch_up(lp, at.time);
    lp_leave_poll(lp);
    return lp_end_at(lp, at.time);
}

void lp_forget(struct lp *lp)
{
    up_drop_deferred(lp);
}

void engine_settle(struct lp *lp, struct instant end)
{
    lp_apply_deferred(lp, instant_later(end, lp->schedule->reached));
    if (lp->state != LP_ENDED)
        up_roll_back_deferred(lp);
}
