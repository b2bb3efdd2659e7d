/* pending.h - calls that a program has made ahead of the machine.
 *
 * A call that only hands something over, a message to send or a receive to post, tells its program nothing. When it is
 * not the machine's earliest event yet, the program does not wait for its turn: the call is noted, with the node's clock, and
 * the program goes on:
 *
 *     program    irecv, csend ------> computes ----> crecv ---> waits
 *     machine            ...... irecv, csend .................. crecv ......
 *
 * Messages are sent in the call's turn, without switching to the program; or at once, with the time when it is, if nothing
 * can reach the node before (protocol_horizon). A receive that selects a message which waits has
 * it at once; others are posted in passing, before anything comes to the node after their turn (pending_make_until). If a message comes before that they may select, they are posted in their turn, too.
 *
 * When messages take the processor meanwhile, the calls whose turn is still to come are put off by that, and with them all that
 * the program has done since. Where the program must know that its turn has come (node_order, node_wait), all its pending
 * calls have been made.
 *
 * So it is with a call that waits, too, if what it waits for is there already and nothing can reach the node before
 * its turn: then the program goes on with its message.
 *
 * What has not had its turn when the program is killed, or the machine stops, has not happened: it is taken back, and the clock
 * with it.
 *
 * Not for nodes with handlers, whose turn is theirs to see, nor where programs can throw away others' messages or end them.
 */
#ifndef NODE_PENDING_H
#define NODE_PENDING_H
#include "node/node.h"

struct message;
struct receive;

/* --- the program's side, in a call that has been entered by node_enter_early --- */

/* Is there room for another? */
bool pending_room(const struct node *n);
/* The call that begins now is pending, until pending.open is false. Call after clock_sync. */
void pending_begin(struct node *n);
/* It goes on: what it waits for will be there. */
void pending_go_on(struct node *n);
/* The call takes t. It may do so, post a receive and send a message (engine.h) once each at most, before it goes on. */
void pending_spend(struct node *n, vtime t);

/* --- the scheduler's side --- */

/* The turn of the first that must be made in it, and what it sends, which may be NULL; VT_NEVER: there is none. */
vtime pending_turn(const struct node *n, struct message **sends);
/* That of the last of all, or when it goes on; there is one. */
vtime pending_last(const struct node *n);
/* A message has come that the receives may select. */
void pending_may_select(struct node *n);
/* Makes those whose turn has come before; there may be none. */
void pending_make(struct node *n, struct instant at);
static inline void pending_make_until(struct node *n, struct instant at)
{
    if (n->pending.count)
        pending_make(n, at);
}
/* The others have not happened, nor has what came after. */
void pending_take_back(struct node *n);
/* Only that: the node has no program any more. */
void pending_unmake(struct node *n);
#endif
