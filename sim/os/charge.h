/* account.h - where a node's time goes: to its operating system, and to waiting. */
#ifndef NODE_ACCOUNT_H
#define NODE_ACCOUNT_H
#include "node/node.h"

/* What takes an ordinary node's system t takes this one's so long; and it has. */
vtime node_system_time(const struct node *n, vtime t);
void node_account(struct node *n, enum node_task task, vtime t);

/* The program, in a call, waits from now on. */
void account_block(struct node *n, vtime now);
/* At a later moment: if a handler is due, or what the program waits for is there (node.wait), it waits no longer: time goes
 * on to now. False: it still waits, and nothing has changed, however often that is asked. */
bool account_unblock(struct node *n, vtime now);
/* It has waited until t, when it is ended. */
void account_cut(struct node *n, vtime t);
#endif
