/* mailbox.h - the messages of a node: receives posted, messages come in unexpected, ids, and handlers due.
 *
 *   an envelope comes:  a posted receive selects it  ->  it is that receive's, and goes straight to its buffer
 *                       none does                    ->  it waits, unexpected, in a system buffer
 *   a receive is made:  the first unexpected message it selects, else it is posted (first posted, first served)
 *
 * unexpected.h says which is the first.
 * A message is complete when it has arrived and the operating system is done with it (message.complete). What NX's calls
 * do with it is declared in nx_api/contract/message.h.
 */
#ifndef NODE_MAILBOX_H
#define NODE_MAILBOX_H
#include "net/proto.h"
#include "node/node.h"
#include "nx_api/contract/message.h"

/* With room for its first ids, for as long as there is the mailbox. */
void mailbox_begin(struct node *n, struct id_block *ids);
void mailbox_end(struct node *n);

/* Throw away the unexpected messages that typesel selects, also those still under way whose envelope has come. */
void mailbox_flush(struct node *n, int64_t typesel, vtime now);

/* The node's program is gone, and what it has posted, too: what one of its receives had selected is lost; what it had sent
 * goes on. Then: throw away all unexpected messages, and those on their way; or hand them to the node's next program. */
void mailbox_abandon(struct node *n);
void mailbox_empty(struct node *n, vtime now);
void mailbox_inherit(struct node *n, struct node *before);

/* Post r at time now: mailbox_post for a call that is made then. */
void mailbox_post_at(struct node *n, struct receive *r, vtime now);
/* Send messages, linked by next, from time now on; returns when the last has left the program. One takes the processor so
 * long. */
vtime mailbox_send(struct node *n, struct message *first, vtime now);
vtime mailbox_send_time(const struct node *n, const struct message *m);

/* What an ordinary node's system takes to copy m to its program's buffer. A program is done with m: a waiting one may get its
 * room. */
vtime mailbox_copying(const struct node *n, const struct message *m);
void mailbox_done_with(struct node *n, struct message *m, vtime now);
/* m, which a receive had selected, is unexpected again, the first. */
void mailbox_put_back(struct node *n, struct message *m);
/* Do long messages wait for room? */
bool mailbox_may_grant(const struct node *n);

/* Follow a message for s until its buffer is free. */
void mailbox_follow(struct message *m, struct send *s);

bool mailbox_ignores(const struct node *n); /* has it ids that the program has told it to look after? */
#endif
