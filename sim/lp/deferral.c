/* deferral.c - see deferral.h. */
#include "lp/deferral.h"
#include "lp/block.h"
#include "lp/clock.h"
#include "lp/dispatch.h"
#include "lp/engine.h"
#include "lp/upcalls.h"

bool lp_may_block_lazily(const struct lp *lp, vtime now)
{
    const struct schedule *s = lp->schedule;
    return lp->state != LP_OFFLOADED && !lp->clock.stolen && !s->stop && now <= s->max_time &&
           !lp_is_passed(lp, now);
}

void lp_apply_deferred(struct lp *lp, struct instant before)
{
    up_commit_deferred(lp, before);
    if (lp->state != LP_BLOCKS_LAZILY || up_has_deferred(lp) ||
        !instant_before(lp_commit_time(lp), lp->address, before))
        return;
    clock_add_stolen(lp);
    lp_block(lp, clock_sync(lp));
}

/* Will what the program waits for be there at its commit time? */
static bool will_be_ready(struct lp *lp)
{
    vtime now = lp->clock.now, then = now + lp->clock.stolen;
    clock_set_time(lp, then);
    bool ready = up_may_resume(lp, then);
    clock_set_time(lp, now);
    return ready;
}

void lp_unblock_lazily(struct lp *lp)
{
    if (lp->state != LP_BLOCKS_LAZILY || lp->scheduled_at || !will_be_ready(lp))
        return;
    lp_become(lp, LP_COMPUTING);
    lp_schedule(lp, lp_commit_time(lp));
}

static void commit_deferred(void *ctx, void *arg, vtime now)
{
    struct lp *lp = ctx;
    (void)arg;
    up_commit_deferred(lp, lp_up_to(lp, now));
    if (lp->scheduled_at != now)
        return;
    lp->scheduled_at = 0;
    lp_schedule_deferred(lp);
    lp_unblock_lazily(lp);
}

void lp_schedule_deferred(struct lp *lp)
{
    void *sends = NULL;
    vtime t = up_next_deferred(lp, &sends);
    if (t == VT_NEVER || (lp->scheduled_at && lp->scheduled_at <= t))
        return;
    lp->scheduled_at = t;
    evq_put_late(lp->schedule->q, t, lp->address, commit_deferred, lp, sends);
}

void lp_message_kept(struct lp *lp)
{
    if (up_has_deferred(lp))
        up_deferred_may_select(lp);
}
