/* dispatch.c - see dispatch.h. */
#include "lp/dispatch.h"
#include "lp/block.h"
#include "lp/clock.h"
#include "lp/commit.h"
#include "lp/engine.h"
#include "lp/lookahead.h"
#include "lp/run_program.h"
#include "lp/upcalls.h"

void lp_schedule(struct lp *lp, vtime t)
{
    evq_put_late(lp->schedule->q, t, lp->address, lp_go_on, lp, NULL);
}

/* The program is paused at a poll, and is not gone on with before t. */
static void pause_at_poll(struct lp *lp, vtime poll_time, vtime t)
{
    if (lp->state != LP_PAUSED)
        lp_become(lp, LP_PAUSED);
    lp->poll_time = poll_time;
    mintree_set(&lp->schedule->polls, lp->address, vt_max(poll_time, t));
}

void lp_leave_poll(struct lp *lp)
{
    if (lp->state != LP_PAUSED)
        return;
    lp_become(lp, LP_COMPUTING);
    mintree_set(&lp->schedule->polls, lp->address, VT_NEVER);
}

/* --- the program's side --- */

/* Is the machine to stop, or the node at the limit of time? Then the coordinator wants to know; and now and
 * then in any case, for limits of host time and signals. */
static bool must_stop(struct lp *lp, vtime now)
{
    struct schedule *s = lp->schedule;
    return s->stop || now > s->max_time || schedule_has_not_looked(s, 1);
}

bool lp_is_next(struct lp *lp, vtime now)
{
    const struct schedule *s = lp->schedule;
    return evq_late_is_first(s->q, now, lp->address) && !commit_poll_is_before(s, now, lp->address) &&
           (!s->workers || workers_allow(s->workers, now, lp->address));
}

bool lp_must_yield(struct lp *lp, vtime now)
{
    if (lp->until)
        return !lp->clock.runs || now >= lp->until;
    return lp->state == LP_OFFLOADED || lp->clock.stolen || !lp_is_next(lp, now) || must_stop(lp, now);
}

void lp_prepare_yield(struct lp *lp, vtime now)
{
    if (lp->state == LP_OFFLOADED)
        lp->arrived = now; /* for offload_take_back */
    else if (lp->clock.runs && lp->interruptible)
        pause_at_poll(lp, now, lp_lookahead(lp));
    else
        lp_schedule(lp, now);
}

void lp_commit(struct lp *lp, vtime now)
{
    if (!lp->until && !lp_is_passed(lp, now))
        schedule_commit(lp->schedule, now, lp->address);
}

void lp_drain(struct lp *lp)
{
    if (!up_has_deferred(lp))
        return;
    lp->drains = true;
    lp_schedule(lp, up_last_deferred(lp));
    lp_yield(lp);
}

static void resume(struct lp *lp, vtime now)
{
    clock_advance_to(lp, now);
    lp_run_on(lp);
}

/* A computing node has come to its call. */
static void arrive(struct lp *lp, vtime now)
{
    const struct schedule *s = lp->schedule;
    clock_advance_to(lp, now);
    if (!up_may_resume(lp, now) && lp_is_next(lp, now) && !s->stop && now <= s->max_time)
        lp_block(lp, now);
    else
        resume(lp, now);
}

void lp_go_on(void *ctx, void *arg, vtime now)
{
    struct lp *lp = ctx;
    (void)arg;
    if (lp->state == LP_ENDED)
        return; /* killed meanwhile */
    up_commit_deferred(lp, lp_up_to(lp, now));
    vtime t = !lp->drains ? lp_commit_time(lp) : up_has_deferred(lp) ? up_last_deferred(lp) : now;
    if (t > now) {
        lp_schedule(lp, t);
    } else if (lp->crashed) {
        clock_drop_stolen(lp);
        clock_advance_to(lp, now);
        up_report_crash(lp);
    } else if (lp->drains) {
        lp->drains = false;
        lp_run_on(lp);
    } else {
        clock_drop_stolen(lp);
        arrive(lp, now);
    }
}

void lp_go_on_from_poll(struct lp *lp)
{
    lp_leave_poll(lp);
    if (lp->clock.stolen)
        lp_go_on(lp, NULL, lp->poll_time);
    else
        lp_run_here(lp);
}

/* --- what happens to a node --- */

void lp_catch_up(struct lp *lp, vtime t)
{
    if (lp->state != LP_PAUSED)
        return;
    if (lp->poll_time < t && !lp->clock.stolen) {
        void *outer = up_nest(lp->schedule);
        lp->until = t;
        lp_go_on_from_poll(lp);
        lp->until = 0;
        up_unnest(lp->schedule, outer);
    }
    if (lp->state == LP_PAUSED)
        pause_at_poll(lp, lp->poll_time, 0);
}

void lp_start(struct lp *lp, vtime t)
{
    clock_advance_to(lp, t);
    lp_schedule(lp, t);
}
