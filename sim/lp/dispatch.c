/* dispatch.c - see dispatch.h. */
#include "lp/dispatch.h"
#include <errno.h>
#include "lp/block.h"
#include "lp/clock.h"
#include "lp/commit.h"
#include "lp/engine.h"
#include "lp/lookahead.h"
#include "lp/prefetch_coming.h"
#include "lp/upcalls.h"

static void go_on(void *ctx, void *arg, vtime now);
static void wake(void *ctx, void *arg, vtime now);

/* Up to the node's moment at `now`, which is included. */
static struct instant up_to(const struct lp *lp, vtime now)
{
    return (struct instant){now, lp->address + 1};
}

/* The program has come, or will, to a call at time t: its commit time. */
static void schedule(struct lp *lp, vtime t)
{
    evq_put_late(lp->schedule->q, t, lp->address, go_on, lp, NULL);
}

/* The program is paused at a poll, and is not gone on with before t. */
static void pause_at_poll(struct lp *lp, vtime poll_time, vtime t)
{
    lp->paused_at_poll = true;
    lp->poll_time = poll_time;
    mintree_set(&lp->schedule->polls, lp->address, vt_max(poll_time, t));
}

void lp_leave_poll(struct lp *lp)
{
    lp->paused_at_poll = false;
    mintree_set(&lp->schedule->polls, lp->address, VT_NEVER);
}

struct lp *lp_coming(const struct schedule *s, unsigned after)
{
    evq_fire *fire;
    struct lp *lp = evq_coming(s->q, after, &fire);
    return fire == go_on || fire == wake ? lp : NULL;
}

/* The commit time of a program that is not offloaded, as far as is known. */
static vtime commit_time(struct lp *lp)
{
    return clock_sync(lp) + lp->clock.stolen;
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
    return lp->offloaded || lp->clock.stolen || !lp_is_next(lp, now) || must_stop(lp, now);
}

void lp_prepare_yield(struct lp *lp, vtime now)
{
    if (lp->offloaded)
        lp->arrived = now; /* for offload_take_back */
    else if (lp->clock.runs && lp->interruptible)
        pause_at_poll(lp, now, lp_lookahead(lp));
    else
        schedule(lp, now);
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
    schedule(lp, up_last_deferred(lp));
    lp_yield(lp);
}

bool lp_may_block_lazily(const struct lp *lp, vtime now)
{
    const struct schedule *s = lp->schedule;
    return !lp->offloaded && !lp->clock.stolen && !s->stop && now <= s->max_time && !lp_is_passed(lp, now);
}

/* --- deferred calls, and blocking without an event --- */

void lp_apply_deferred(struct lp *lp, struct instant before)
{
    up_commit_deferred(lp, before);
    if (!lp->lazily_blocked || up_has_deferred(lp) || !instant_before(commit_time(lp), lp->address, before))
        return;
    lp->lazily_blocked = false;
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

/* A lazily blocked program resumes at its commit time if what it waits for is there. Deferred calls that have
 * an event are committed first: messages may delay these, and the commit time with them. */
static void unblock_lazily(struct lp *lp)
{
    if (!lp->lazily_blocked || lp->scheduled_at || !will_be_ready(lp))
        return;
    lp->lazily_blocked = false;
    schedule(lp, commit_time(lp));
}

static void commit_deferred(void *ctx, void *arg, vtime now)
{
    struct lp *lp = ctx;
    (void)arg;
    up_commit_deferred(lp, up_to(lp, now));
    if (lp->scheduled_at != now)
        return;
    lp->scheduled_at = 0;
    lp_schedule_deferred(lp);
    unblock_lazily(lp);
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

/* --- running programs --- */

void lp_run(struct lp *lp)
{
    up_program_resumes(lp);
    errno = lp->saved_errno;
    fiber_resume(&lp->fiber);
    lp->crashed = up_program_returns(lp);
    clock_sync(lp);
    lp->saved_errno = errno;
}

void lp_crash(struct lp *lp)
{
    if (lp->clock.runs)
        clock_crash(lp);
    schedule(lp, clock_sync(lp));
}

static void run_here(struct lp *lp)
{
    lp->state = LP_COMPUTING;
    lp->schedule->unseen = 0;
    lp_run(lp);
    if (lp->crashed)
        lp_crash(lp);
    else if (lp->offloaded)
        workers_submit(lp->schedule->workers, &lp->offload.task);
}

static void run_on(struct lp *lp)
{
    lp->schedule->switches++;
    prefetch_coming(lp->schedule);
    run_here(lp);
}

static void resume(struct lp *lp, vtime now)
{
    clock_advance_to(lp, now);
    run_on(lp);
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

/* The commit time of a node that computes ahead: of its call, or its crash. */
static void go_on(void *ctx, void *arg, vtime now)
{
    struct lp *lp = ctx;
    (void)arg;
    if (lp->state == LP_ENDED)
        return; /* killed meanwhile */
    up_commit_deferred(lp, up_to(lp, now));
    vtime t = !lp->drains ? commit_time(lp) : up_has_deferred(lp) ? up_last_deferred(lp) : now;
    if (t > now) {
        schedule(lp, t);
    } else if (lp->crashed) {
        clock_drop_stolen(lp);
        clock_advance_to(lp, now);
        up_report_crash(lp);
    } else if (lp->drains) {
        lp->drains = false;
        run_on(lp);
    } else {
        clock_drop_stolen(lp);
        arrive(lp, now);
    }
}

void lp_go_on_from_poll(struct lp *lp)
{
    lp_leave_poll(lp);
    if (lp->clock.stolen)
        go_on(lp, NULL, lp->poll_time);
    else
        run_here(lp);
}

static void wake(void *ctx, void *arg, vtime now)
{
    struct lp *lp = ctx;
    (void)arg;
    lp_apply_deferred(lp, schedule_reached(lp->schedule));
    unblock_lazily(lp);
    if (lp->state == LP_BLOCKED && lp_unblock(lp, now))
        run_on(lp);
}

/* --- what happens to a node --- */

void lp_catch_up(struct lp *lp, vtime t)
{
    if (!lp->paused_at_poll)
        return;
    if (lp->poll_time < t && !lp->clock.stolen) {
        void *outer = up_nest(lp->schedule);
        lp->until = t;
        lp_go_on_from_poll(lp);
        lp->until = 0;
        up_unnest(lp->schedule, outer);
    }
    if (lp->paused_at_poll)
        pause_at_poll(lp, lp->poll_time, 0);
}

void lp_synchronise(struct lp *lp)
{
    if (!lp->paused_at_poll && !up_has_deferred(lp) && !lp->lazily_blocked)
        return;
    struct instant at = schedule_reached(lp->schedule);
    if (lp->paused_at_poll)
        lp_catch_up(lp, at.time + (lp->address < at.address));
    lp_apply_deferred(lp, at);
}

void lp_notify(struct lp *lp, vtime t)
{
    lp_apply_deferred(lp, schedule_reached(lp->schedule));
    unblock_lazily(lp);
    vtime commits = lp->offloaded ? lp->schedule->present.time + lp->clock.stolen : commit_time(lp);
    if (lp->state == LP_BLOCKED || commits < t)
        lp_wake(lp, t);
    /* else the node, which has an event, asks at its commit time, not before t */
}

void lp_wake(struct lp *lp, vtime t)
{
    evq_put_late(lp->schedule->q, t, lp->address, wake, lp, NULL);
}

void lp_start(struct lp *lp, vtime t)
{
    schedule(lp, t);
}

void lp_message_kept(struct lp *lp)
{
    if (up_has_deferred(lp))
        up_deferred_may_select(lp);
}
