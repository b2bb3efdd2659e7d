/* turns.h - the scheduler's side of cpu.h: whose turn it is, and what a node does with its own. For cpu.c, which has the
 * program's side.
 *
 * An event of a node is that it goes on (its start, a call), that pending calls have their turn or, blocked, that it looks again at
 * what it waits for (node_wake). Its checks are not events, but bounds beside the queue (node_system.checks). */
#ifndef NODE_TURNS_H
#define NODE_TURNS_H
#include "node/node.h"

/* The program has come, or will, to a call at time t: then is its turn. */
void turn_put(struct node *n, vtime t);
/* It has stopped at a check, and is not gone on with before t: until then it makes no call. */
void turn_at_check(struct node *n, vtime check, vtime t);
/* Is the node's call or check at `now` the machine's earliest event? */
bool turn_is_first(struct node *n, vtime now);
/* The program, in a call, waits from now on. */
void turn_block(struct node *n, vtime now);
/* May the program, in a call at `now`, rest? As far as is known it will be blocked there. Then no event is put for that: either
 * something comes to the node before, or it has been blocked in passing. */
bool turn_may_rest(const struct node *n, vtime now);
/* Its pending calls are made, and it is blocked if it rests, as far as their turns come before. Called before anything is done
 * to the node that they could matter to. */
void turn_settle(struct node *n, struct instant before);
/* From time t on there is something that it may wait for, which is looked at now or then. */
void turn_look(struct node *n, vtime t);
/* The event queue is to know of the turn of the next of its pending calls that must be made in it. */
void turn_tell(struct node *n);
#endif
