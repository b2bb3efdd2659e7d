/* share.h - the share of its processor that a program has between two handlers.
 *
 * Handlers may follow each other without a gap for as long as others send. So that the interrupted program
 * makes progress, a handler that has taken the time h leaves the program at least h p / (1 - p) for computing
 * and calls before the next handler. p is the machine's program_share. A program that waits needs no share.
 */
#ifndef OS_SHARE_H
#define OS_SHARE_H
#include "node/node.h"

/* A handler has taken the program the time h. */
void share_give(struct node *n, vtime h);
/* The program has spent t of its share in calls. */
void share_use(struct node *n, vtime t);
/* The program waits. */
void share_end(struct node *n);
#endif
