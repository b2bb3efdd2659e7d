/* turns.h - the scheduler's side of cpu.h: whose turn it is, and what a node does with its own. For cpu.c, which has the
 * program's side.
 *
 * An event of a node is that it goes on (its start, a call, the first of its pending calls) or, blocked, looks again at what it
 * waits for (node_wake). Its checks are not events, but bounds beside the queue (node_system.checks). */
#ifndef NODE_TURNS_H
#define NODE_TURNS_H
#include "node/node.h"

/* The program has come, or will, to a call at time t: then is its turn. */
void turn_put(struct node *n, vtime t);
/* It has stopped at a check, and is not gone on with before t: until then it makes no call. */
void turn_at_check(struct node *n, vtime check, vtime t);
/* Is the node's call or check at `now` the machine's earliest event? */
bool turn_is_first(struct node *n, vtime now);
/* Has the machine been told to stop, or this node come to the end of time? */
bool turn_past_end(struct node *n, vtime now);
/* The program, in a call, waits from now on. */
void turn_block(struct node *n, vtime now);
#endif
