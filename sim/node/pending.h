/* pending.h - calls that a program has made ahead of the machine.
 *
 * A call that only hands something over, a message to send or a receive to post, tells its program nothing. When it is
 * not the machine's earliest event yet, the program does not wait for its turn: the call is noted, pending, with the
 * node's clock, and the program goes on. At its place in the order of events the scheduler does what it is to do,
 * without switching to the program:
 *
 *     program    csend ------> computes ----> crecv ---> waits, behind all that is pending
 *     machine            ...... csend .................. crecv ...... ready? blocked
 *
 * When messages have taken the processor meanwhile, a pending call comes later by that, and with it all that the program
 * has done since. Where the program must know that its turn has come (node_order, node_wait), all its pending calls have
 * been made. What is still pending when it is killed, or the machine stops, has not happened: the clock goes back.
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
/* The call that begins now is pending. Call after clock_sync. */
void pending_begin(struct node *n);
/* The call that is being made takes t, posts r, sends messages (linked by next) to so many receivers. Once each at most. */
void pending_spend(struct node *n, vtime t);
void pending_post(struct node *n, struct receive *r);
void pending_send(struct node *n, struct message *first, uint64_t receivers);
/* It is made, or has come into order. */
void pending_end(struct node *n);

/* --- the scheduler's side --- */

/* When the first comes, if nothing else puts it back. */
vtime pending_next(const struct node *n);
/* Makes it, at time now. */
void pending_commit(struct node *n, vtime now);
/* None of them has happened, nor what came after. */
void pending_take_back(struct node *n);
void pending_free(struct node *n);
#endif
