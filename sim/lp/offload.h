/* offload.h - compute segments as tasks that any thread may run (kernel/workers.h).
 *
 * A program that no handler may interrupt is offloaded when its segment will probably be long. Programs
 * paused at polls are when at least two of them have far to compute before anything can reach any of them. */
#ifndef LP_OFFLOAD_H
#define LP_OFFLOAD_H
#include "lp/lp.h"

/* --- the program's side, on its stack --- */

/* A compute segment is over, and a call begins: notes how long the segment was behind the call before. */
void offload_note_segment(struct lp *lp, const char *call);
/* Will the program probably compute for long behind its call? */
bool offload_is_long_next(const struct lp *lp);
/* When the program has left its call: offloads it if that is worth while. */
void offload_at_leave(struct lp *lp);
/* At a poll where the program is not to be interrupted, at `now`: offloads it if the segment has become long.
 * True: it is offloaded, or has been; others have gone on meanwhile. */
bool offload_at_poll(struct lp *lp, vtime now);

/* --- the coordinator's side --- */

/* The next poll time is the node's. If it has far to compute until its next call, others may have, too:
 * offloads them all. False: that is not worth while. */
bool offload_paused(struct lp *lp);
/* Takes an offloaded program back that has come to its next call or poll, or has crashed. */
void offload_take_back(struct task *t);
/* Stops the program's task, if there is one: the program is not wanted any more. */
void offload_drop(struct lp *lp);

/* --- on any thread --- */

/* Runs an offloaded program until it comes to its next call, crashes (true), or pauses (false). */
bool offload_run(struct task *t);
#endif
