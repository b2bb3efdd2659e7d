/* unexpected.h - the messages that have come to a node and that no receive has selected, in the order in
 * which receives and probes find them:
 *
 *     whole    all their bytes are here; in the order in which they came whole
 *     coming   their envelope has come, some of their bytes have not; in the order of envelopes
 *
 * Of the messages of one program and one type the one sent first is found first, whatever comes whole first:
 * one that is whole before an earlier one is among the coming until that is whole, too. So a probe and the
 * receive behind it find the same message: what comes whole between them comes behind it. */
#ifndef NODE_UNEXPECTED_H
#define NODE_UNEXPECTED_H
#include "node/node.h"

void unexpected_begin(struct node *n);
void unexpected_end(struct node *n); /* whose messages have been freed, or are another's */
/* An envelope has come. */
void unexpected_add(struct node *n, struct message *m);
/* One of them has arrived: all its bytes are here. */
void unexpected_has_arrived(struct node *n, const struct message *m);
/* The first that is selected; NULL: none is. */
struct message *unexpected_first(const struct node *n, const struct selector *select);
/* m, one of them, is not any more; m is again, and the first. */
void unexpected_take(struct node *n, struct message *m);
void unexpected_put_back(struct node *n, struct message *m);
/* n, which has none, has those of a node before, which has none then. */
void unexpected_inherit(struct node *n, struct node *before);
#endif
