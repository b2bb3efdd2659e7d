/* block.c - see block.h. */
#include "lp/block.h"
#include "lp/clock.h"
#include "lp/upcalls.h"

void lp_block(struct lp *lp, vtime now)
{
    lp_become(lp, LP_BLOCKED);
    lp->blocked_since = now;
    up_wait_begins(lp);
}

bool lp_unblock(struct lp *lp, vtime now)
{
    clock_set_time(lp, now); /* which up_may_resume may ask for */
    if (!up_may_resume(lp, now)) {
        clock_set_time(lp, lp->blocked_since);
        return false;
    }
    up_wait_ends(lp, now);
    lp_become(lp, LP_COMPUTING);
    return true;
}

bool lp_end_at(struct lp *lp, vtime t)
{
    vtime commits = clock_sync(lp) + lp->clock.stolen;
    if (lp->state == LP_BLOCKED)
        up_wait_ends(lp, t);
    else if (commits >= t) /* if it is just there, too: fewer units may take as long */
        clock_roll_back(lp, commits - t);
    clock_drop_stolen(lp);
    return lp_computes(lp);
}
