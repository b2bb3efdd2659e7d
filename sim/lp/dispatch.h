/* dispatch.h - a node's moments: its commit times and poll times, and what happens when they have come. lp.h
 * has the states.
 *
 * An event of a node is that it goes on (its start, a call), that deferred calls are committed or, blocked,
 * that it is asked whether it may resume (lp_wake). Its poll times are not events, but bounds beside the
 * queue (schedule.polls). */
#ifndef LP_DISPATCH_H
#define LP_DISPATCH_H
#include "lp/lp.h"

/* --- the program's side, on its stack --- */

/* Must the program, at `now` in a call or at a poll, let others go on before it? */
bool lp_must_yield(struct lp *lp, vtime now);
/* Before it does: sees to its commit time, or poll time. (An offloaded program's is seen to when its task is
 * taken back.) */
void lp_prepare_yield(struct lp *lp, vtime now);
/* Switches to the coordinator, until the program resumes. */
static inline void lp_yield(struct lp *lp)
{
    fiber_yield(&lp->fiber);
}
/* The program's moment has come, maybe without an event: commits it. (Where the program only catches up, that
 * was long ago.) */
void lp_commit(struct lp *lp, vtime now);
/* Yields until all deferred calls have been committed. */
void lp_drain(struct lp *lp);
/* May the program, in a call at `now`, block lazily? As far as is known, it will be blocked there. No event
 * is queued for that: either something reaches the node before, or lp_apply_deferred blocks it. */
bool lp_may_block_lazily(const struct lp *lp, vtime now);
static inline void lp_block_lazily(struct lp *lp)
{
    lp->lazily_blocked = true;
}
/* Is the node's call or poll at `now` the machine's earliest event? */
bool lp_is_next(struct lp *lp, vtime now);

/* --- the coordinator's side --- */

/* The program is not paused at a poll any more. */
void lp_leave_poll(struct lp *lp);
/* Commits its deferred calls, and blocks it if it is lazily blocked, as far as their commit times come
 * before. Called before anything is done to the node that they could matter to. */
void lp_apply_deferred(struct lp *lp, struct instant before);
/* The event queue is to know of the first deferred call that needs an event. */
void lp_schedule_deferred(struct lp *lp);
/* A program paused at a poll computes up to the first poll at or past t, or its call. Called before anything
 * is done to the node that depends on how far it has come. */
void lp_catch_up(struct lp *lp, vtime t);
/* Its program has crashed, in a call, or computing: reported at the time of its clock, which messages may put
 * off as they do a call. */
void lp_crash(struct lp *lp);
/* Lets the program run on the calling thread until it yields. */
void lp_run(struct lp *lp);
/* The poll time of the node has come. */
void lp_go_on_from_poll(struct lp *lp);
/* The node whose event comes so many after the next; NULL: unknown, or something else happens then. */
struct lp *lp_coming(const struct schedule *s, unsigned after);
#endif
