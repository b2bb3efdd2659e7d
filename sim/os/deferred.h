/* deferred.h - calls that a program has left before they are committed.
 *
 * A call that only hands something over, a message to send or a receive to post, tells its program nothing.
 * When the machine has not come to the call's commit time yet, the program does not wait for it: the call is
 * noted, with the node's clock, and the program resumes at once:
 *
 *     program    irecv, csend ------> computes ----> crecv ---> waits
 *     machine            ...... irecv, csend .................. crecv ......
 *
 * A message is sent at the call's commit time, by an event, without switching to the program; or at once,
 * with the time of then, if nothing can reach the node before (lp/lookahead.h). A receive that selects an
 * unexpected message has it at once, also one that comes whole before the receive's commit time. Other
 * receives are posted without an event, before anything reaches the node after their commit time
 * (deferred_commit_until). If the envelope of a long message comes before that they may select, they get an
 * event, too.
 *
 * When messages take the processor meanwhile, the deferred calls, and all that the program has done since,
 * come so much later. Where the program must know that its moment is committed (node_order, node_wait), all
 * its deferred calls have been.
 *
 * A call that waits is deferred, too, if the message it waits for has arrived and nothing can reach the node
 * before its commit time: the caller resumes at once. So is one that asks for what has not come by then: a
 * program that polls would switch at each poll.
 *
 * What is not committed when the program is killed, or the machine stops, has not happened: it is rolled
 * back, and the clock with it.
 *
 * Not for nodes with handlers, which interrupt at commit times, nor where programs can throw away others'
 * messages or end them. */
#ifndef OS_DEFERRED_H
#define OS_DEFERRED_H
#include "node/node.h"

struct message;
struct receive;

/* --- the program's side, in a call that has been entered by node_enter_early --- */

/* Is there room for another? */
bool deferred_has_room(const struct node *n);
/* The call that begins now is deferred, until deferred.open is false. Call after clock_sync. */
void deferred_begin(struct node *n);
/* The same for a call that asks, and is answered no. */
void deferred_ask(struct node *n);
/* Is all that is deferred such calls? There is a deferred call. */
bool deferred_only_ask(const struct node *n);
/* Its caller resumes at once: the message it waits for has arrived. */
void deferred_resume_caller(struct node *n);
/* The call takes t, posts a receive, sends a message: each once at most, before its caller resumes. */
void deferred_spend(struct node *n, vtime t);
void deferred_post(struct node *n, struct receive *r);
void deferred_send(struct node *n, struct message *m);
/* It consumes a message, whose bytes the program has. */
void deferred_received(struct node *n, struct message *m);

/* --- the coordinator's side --- */

/* The commit time of the first that needs an event, and what it sends, which may be NULL; VT_NEVER: there is
 * none. */
vtime deferred_next(const struct node *n, struct message **sends);
/* That of the first of all, which has not begun. */
static inline vtime deferred_begins(const struct node *n)
{
    return n->deferred.commits + n->lp.clock.stolen;
}
/* That of the last of all, or when its caller resumes; there is one. */
vtime deferred_last(const struct node *n);
/* A message is kept that the receives may select: it has come whole, or its envelope. */
void deferred_may_select(struct node *n);
/* Does the commit time of one come before? */
static inline bool deferred_is_due(const struct node *n, struct instant before)
{
    return n->deferred.count &&
           instant_before(n->deferred.commits + n->lp.clock.stolen, n->lp.address, before);
}
/* Commits those. (Most often there is none: deferred_commit_until is inlined, and the rest is not.) */
__attribute__((noinline)) void deferred_commit(struct node *n, struct instant before);
static inline void deferred_commit_until(struct node *n, struct instant before)
{
    if (deferred_is_due(n, before))
        deferred_commit(n, before);
}
/* The others have not happened, nor has what came after. */
void deferred_roll_back(struct node *n);
/* Only that: the node has no program any more. */
void deferred_undo(struct node *n);
#endif
