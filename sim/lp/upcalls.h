/* upcalls.h - what sim/lp asks of the operating system above it (sim/os/upcalls.c): the only calls up.
 *
 * A node's deferred calls (os/deferred.h) and handlers (os/handlers.h) are the operating system's; sim/lp
 * decides when their moments have come. */
#ifndef LP_UPCALLS_H
#define LP_UPCALLS_H
#include "lp/lp.h"

/* The node at an address; NULL: no program's. */
struct lp *up_lp_at(struct schedule *s, uint32_t address);

/* --- deferred calls --- */

bool up_has_deferred(const struct lp *lp);
/* Commits those whose commit time comes before; there may be none. */
void up_commit_deferred(struct lp *lp, struct instant before);
/* The commit time of the first that needs an event; VT_NEVER: none does. *sends: the message that it sends,
 * for loading ahead, or NULL. */
vtime up_next_deferred(const struct lp *lp, void **sends);
/* The commit time of the last, or when its caller resumes; there must be one. */
vtime up_last_deferred(const struct lp *lp);
/* A message has come that deferred receives may select. */
void up_deferred_may_select(struct lp *lp);
/* Rolls back the calls that are not committed, and all that the program has done since. */
void up_roll_back_deferred(struct lp *lp);
/* The same for a node without a program: only messages and times are given back. */
void up_drop_deferred(struct lp *lp);

/* --- handlers and waits --- */

/* May a handler have to run before the program's next call? */
bool up_is_interruptible(const struct lp *lp);
bool up_in_handler(const struct lp *lp);
/* When the next handler is to interrupt the program, if that computes until then; VT_NEVER: none is due. */
vtime up_next_interrupt(const struct lp *lp);
/* At `now`: is a handler due, or is there what the program waits for? True, too, when it waits for nothing.
 */
bool up_may_resume(struct lp *lp, vtime now);
/* The program begins to wait; it has waited until t, since lp.blocked_since. */
void up_wait_begins(struct lp *lp);
void up_wait_ends(struct lp *lp, vtime t);

/* --- programs --- */

/* The program is going to run on the calling thread. The program has run; true: it has crashed, and the crash
 * is noted. */
void up_program_resumes(struct lp *lp);
bool up_program_returns(struct lp *lp);
/* Reports the crash noted, at its moment. */
void up_report_crash(struct lp *lp);
/* Another program is going to run within a call of the one that runs: returns the latter. Then the latter
 * goes on. */
void *up_nest(struct schedule *s);
void up_unnest(struct schedule *s, void *outer);
/* The limit of virtual time is reached: stops the machine. */
void up_end_at_limit(struct schedule *s);

/* --- loading ahead: kernel/prefetch.h --- */

/* What every program needs of its node; what its next call will look at; messages in these; its stack and
 * variables. */
void up_prefetch_node(const struct lp *lp);
void up_prefetch_receives(const struct lp *lp);
void up_prefetch_messages(const struct lp *lp);
void up_prefetch_program(const struct lp *lp);
#endif
