/* dispatch.h - a node's moments: its commit times and poll times, and what happens when they have come. lp.h
 * has the states.
 *
 * The queue has three kinds of events of a node: it goes on (its start; the commit time of a call), its
 * deferred calls are committed (deferral.h), and it is woken (wake.h). Poll times are not in the queue, but
 * beside it (schedule.polls). */
#ifndef LP_DISPATCH_H
#define LP_DISPATCH_H
#include "lp/clock.h"

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
/* Is the node's call or poll at `now` the machine's earliest event? */
bool lp_is_next(struct lp *lp, vtime now);

/* --- the coordinator's side --- */

/* The program is not paused at a poll, or not any more. */
void lp_leave_poll(struct lp *lp);
/* A program paused at a poll computes up to the first poll at or past t, or its call. Called before anything
 * is done to the node that depends on how far it has come. */
__attribute__((noinline)) void lp_catch_up(struct lp *lp, vtime t);
/* Goes on with a program paused at a poll, whose poll time has come. */
void lp_go_on_from_poll(struct lp *lp);
/* An event (ctx: the node): the commit time of a program that computes ahead, of its call or its crash. */
void lp_go_on(void *ctx, void *arg, vtime now);
/* The program has come, or will, to a call at time t: puts its commit time into the queue. */
void lp_schedule(struct lp *lp, vtime t);
/* The commit time of a program that is not offloaded, as far as is known. */
static inline vtime lp_commit_time(struct lp *lp)
{
    return clock_sync(lp) + lp->clock.stolen;
}
#endif
