/* pending.h - calls that a program has made ahead of the machine.
 *
 * A call that only hands something over, a message to send or a receive to post, tells its program nothing. When it is
 * not the machine's earliest event yet, the program does not wait for its turn: the call is noted, with the node's clock, and
 * the program goes on. At its place in the order of events the scheduler does what it is to do, without switching to the
 * program:
 *
 *     program    csend ------> computes ----> crecv ---> waits, behind all that is pending
 *     machine            ...... csend .................. crecv ...... ready? blocked
 *
 * When messages have taken the processor meanwhile, a pending call comes later by that, and with it all that the program
 * has done since. Where the program must know that its turn has come (node_order, node_wait), all its pending calls have
 * been made.
 *
 * If nothing can reach the node before the call's turn (proto_horizon), the call is made at once: messages and receives have
 * their times with them, and nobody sees them earlier. Then it has no event of its own. So it is with the end of a call that
 * waits, if what it waits for is there already: then the program goes on with its message.
 *
 * What has not had its turn when the program is killed, or the machine stops, has not happened: it is taken back, and the clock
 * with it.
 *
 * Not for nodes with handlers, whose turn is theirs to see, nor for the host.
 */
#ifndef NODE_PENDING_H
#define NODE_PENDING_H
#include "node/node.h"

struct message;
struct receive;

/* --- the program's side, in a call that has been entered by node_enter_early --- */

/* Is there room for another? */
bool pending_room(const struct node *n);
/* The call that begins now, or what is left of it, is pending; made: it is to be made before its turn. Call after
 * clock_sync. */
void pending_begin(struct node *n, bool made);
/* The call that is being made takes t, posts r, sends messages (linked by next) to so many receivers: once each at most. It
 * is done with m, which the program has got. */
void pending_spend(struct node *n, enum node_task task, vtime t);
void pending_post(struct node *n, struct receive *r);
void pending_send(struct node *n, struct message *first, uint64_t receivers);
void pending_take(struct node *n, struct message *m);
/* It ends, or has come into order. False: the queue knows of none that is pending, but this one must be made in its turn. */
bool pending_end(struct node *n);
/* All are made before their turn. */
void pending_make(struct node *n);

/* --- the scheduler's side --- */

/* When the first that is to be made comes, if nothing else puts it back. */
vtime pending_next(const struct node *n);
/* The same; the queue is to know of it from now on. */
vtime pending_tell(struct node *n);
/* Makes it, at time now. */
void pending_commit(struct node *n, vtime now);
/* Makes those of which the queue knows nothing and whose turn has come before. True: there are others. */
bool pending_make_until(struct node *n, struct instant at);
/* The node has its turn: all that have been made have happened. */
void pending_forget(struct node *n);
/* The program has crashed in the one that it was in, whose turn comes then. */
vtime pending_crashes(struct node *n);
/* Those whose turn has not come before then have not happened, nor has what came after. */
void pending_take_back(struct node *n, struct instant at);
void pending_free(struct node *n);
#endif
