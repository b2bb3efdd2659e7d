/* handlers.h - the handlers of a node: those of hrecv, hsend and their kin. They run in the order in which they became due.
 *
 * Handlers may follow each other without a gap for as long as others send. So that the program which they interrupt goes on, one that
 * has taken it the time h leaves it at least h p / (1 - p) for computing and calls before the next, where p is the machine's
 * program_share. A program that waits needs no share. */
#ifndef NODE_HANDLERS_H
#define NODE_HANDLERS_H
#include "node/node.h"

struct receive;
struct send;

/* One is due from time `at` on: for r, whose message is complete then, or for s, whose buffer is free. */
void handlers_add(struct node *n, vtime at, struct receive *r, struct send *s);
/* Throws away those that are due. */
void handlers_free(struct mailbox *b);
/* May one have to be run before the program's next call? */
bool handlers_armed(const struct node *n);
/* When the next is to interrupt the program, if that computes until then; VT_NEVER: none is known to be due. */
vtime handlers_next_due(const struct node *n);
/* Is one due that a program which waits lets run at this time? */
bool handlers_due(const struct node *n, vtime now);
/* On the node's stack, in its turn: runs the first that is due, if it may interrupt the program; one that waits for something that is
 * not there may be interrupted at any time. False: none. When one has run, the program's time is later, and what happens before is to
 * happen before the next (node_order). */
bool handlers_run(struct node *n, bool waits);
/* Runs the first if it was due at time t, until which it was held back. */
bool handlers_run_held(struct node *n, vtime t);
/* Masks them, or lets them run; were they masked before? */
bool handlers_mask(struct node *n, bool masked);
/* The program waits: it needs no share of its processor. */
void handlers_need_no_share(struct node *n);
/* The program, or a handler, has been in the system for t on its own account. */
void handlers_share_used(struct node *n, vtime t);
/* They are no longer held back, by the program or by another that ran. */
void handlers_open(struct node *n);
#endif
