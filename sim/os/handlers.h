/* handlers.h - the handlers of a node: those of hrecv, hsend and their variants. They run in the order in
 * which they became due (due.h), on the program's stack, one at a time, and not while they are masked;
 * between two of them the program has its share (share.h). */
#ifndef OS_HANDLERS_H
#define OS_HANDLERS_H
#include "os/due.h"

/* On the node's stack, at a committed moment: runs the first that is due, if it may interrupt the program;
 * one that waits for something that is not there may be interrupted at any time. False: none. When one has
 * run, the program's time is later, and what comes before is to be committed before the next (node_order). */
__attribute__((noinline)) bool handlers_run_due(struct node *n, bool waits);
static inline bool handlers_run(struct node *n, bool waits)
{
    return due_first(&n->mailbox) && handlers_run_due(n, waits);
}
/* Runs the first if it was due at time t, until which it was held back. */
bool handlers_run_held(struct node *n, vtime t);
/* Masks them, or lets them run; were they masked before? */
bool handlers_mask(struct node *n, bool masked);
/* They are no longer held back, by the program or by another that ran. */
void handlers_open(struct node *n);
#endif
