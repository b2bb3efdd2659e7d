/* front.h - what a call does now, or defers: that is asked in front.c, and nowhere else. (The reference
 * engine defers nothing.) */
#ifndef OS_FRONT_H
#define OS_FRONT_H
#include "node/node.h"

struct receive;
struct message;

/* Spends operating system time in a call: NODE_CALL, or the task named. */
void node_spend_on(struct node *n, enum node_task task, vtime t);
static inline void node_spend(struct node *n, vtime t)
{
    node_spend_on(n, NODE_CALL, t);
}
/* Posts a receive; sends messages, linked by next; gives back a message whose bytes the program has, after
 * the system's copying. */
void front_post(struct node *n, struct receive *r);
void front_send(struct node *n, struct message *first);
void front_received(struct node *n, struct message *m);
#endif
