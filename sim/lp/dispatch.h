/* dispatch.h - a node's moments: its commit times and poll times, and what happens when they have come. lp.h
 * has the states.
 *
 * The queue has three kinds of events of a node: it goes on (its start; the commit time of a call), its
 * deferred calls are committed, and it is woken (a blocked node is asked whether it may resume). Poll times
 * are not in the queue, but beside it (schedule.polls). */
#ifndef LP_DISPATCH_H
#define LP_DISPATCH_H
#include "lp/lp.h"

/* --- the program's side, on its stack --- */

/* Must the program, at `now` in a call or at a poll, let others go on before it? */
bool lp_must_yield(struct lp *lp, vtime now);
/* To be called before it yields: schedules its commit time, or its poll time. (For an offloaded program,
 * offload_take_back() does that.) */
void lp_prepare_yield(struct lp *lp, vtime now);
/* Switches to the coordinator, until the program resumes. */
static inline void lp_yield(struct lp *lp)
{
    fiber_yield(&lp->fiber);
}
/* Commits the program's moment, which has come, maybe without an event. (A program that only catches up does
 * nothing here: others have been committed since.) */
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
/* Commits the deferred calls whose commit times come before a moment, and blocks a lazily blocked node if its
 * commit time does. Called before anything is done to the node that this could matter to. */
void lp_apply_deferred(struct lp *lp, struct instant before);
/* Puts an event into the queue for the first deferred call that needs one. */
void lp_schedule_deferred(struct lp *lp);
/* A program paused at a poll computes up to the first poll at or past t, or its call. Called before anything
 * is done to the node that depends on how far it has come. */
void lp_catch_up(struct lp *lp, vtime t);
/* The program has crashed, in a call or computing: schedules the report, at the time of its clock. Messages
 * may put the report off as they put off a call. */
void lp_crash(struct lp *lp);
/* Lets the program run on the calling thread until it yields. */
void lp_run(struct lp *lp);
/* Goes on with a program paused at a poll, whose poll time has come. */
void lp_go_on_from_poll(struct lp *lp);
/* The node whose event comes so many after the next; NULL: unknown, or something else happens then. */
struct lp *lp_coming(const struct schedule *s, unsigned after);
#endif
