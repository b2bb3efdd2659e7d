/* unexpected.h - the messages that have come to a node and that no receive has selected, in the order in
 * which receives and probes find them:
 *
 *     whole    all their bytes are here; in the order in which they came whole
 *     coming   their envelope has come, some of their bytes have not; in the order of envelopes
 *
 * Of the messages of one program and one type, receives and probes find the one sent first, whichever is
 * whole first: a message stays among the coming until all messages of its program and type that were sent
 * before it are whole. So a probe and the receive that follows find the same message: a message that becomes
 * whole between the two comes behind it in the order. */
#ifndef NODE_UNEXPECTED_H
#define NODE_UNEXPECTED_H
#include "node/node.h"

void unexpected_begin(struct node *n);
void unexpected_end(struct node *n); /* whose messages have been freed, or are another's */
/* An envelope has come. */
void unexpected_add(struct node *n, struct message *m);
/* All bytes of m, which is unexpected, are here. */
void unexpected_has_arrived(struct node *n, const struct message *m);
/* The first message that is selected; NULL: none. */
struct message *unexpected_first(const struct node *n, const struct selector *select);
/* Takes m off; puts m back, to its place in the order. */
void unexpected_take(struct node *n, struct message *m);
void unexpected_put_back(struct node *n, struct message *m);
/* Moves the messages of the node `before` to n, which has none. */
void unexpected_inherit(struct node *n, struct node *before);
#endif
