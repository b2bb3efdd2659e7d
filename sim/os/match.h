/* match.h - the matching of receives and messages: receives posted, messages come in unexpected, system
 * buffers and grants.
 *
 *   an envelope comes:  a posted receive selects it  ->  it is that receive's, and goes to its buffer
 *                       none does                    ->  it waits, unexpected, in a system buffer
 *   a receive is made:  the first unexpected message it selects, else it is posted (first come, first served)
 *
 * unexpected.h says which is the first. A message is complete when it has arrived and the operating system is
 * done with it (message.complete). Functions are told at what time they happen; whether a call is deferred is
 * asked in front.c. */
#ifndef OS_MATCH_H
#define OS_MATCH_H
#include "net/protocol.h"
#include "node/node.h"

void match_begin(struct node *n);
void match_end(struct node *n);

/* Throws away the unexpected messages that typesel selects, also those still under way whose envelope has
 * come. */
void match_flush(struct node *n, int64_t typesel, vtime now);

/* The node's program is gone, and what it has posted, too: what one of its receives had selected is lost;
 * what it had sent goes on. Then: throws away all unexpected messages, and those on their way; or hands them
 * to the node's next program. */
void match_abandon(struct node *n);
void match_empty(struct node *n, vtime now);
void match_inherit(struct node *n, struct node *before);

/* Posts r at time now, or gives it the unexpected message that it selects. Gives it that one. Withdraws it;
 * true: the message that it had selected is unexpected again. Then posted receives are to be served that may
 * select that message. */
void match_post(struct node *n, struct receive *r, vtime now);
__attribute__((noinline)) void match_select(struct node *n, struct receive *r, struct message *m, vtime now);
bool match_withdraw(struct node *n, struct receive *r);
void match_serve_posted(struct node *n, vtime now);
/* Sends messages, linked by next, from time now on; returns when the last has left the program. One takes the
 * processor so long. */
vtime match_send(struct node *n, struct message *first, vtime now);
vtime match_send_time(const struct node *n, const struct message *m);
/* By how much the messages that a call sends next leave late, in a run with another timing than usual. */
vtime match_send_late(const struct node *n);

/* What an ordinary node's system takes to copy m to its program's buffer. A program is done with m: a waiting
 * one may get its room. */
vtime match_copying(const struct node *n, const struct message *m);
void match_done_with(struct node *n, struct message *m, vtime now);
/* m, which a receive had selected, is unexpected again. */
void match_put_back(struct node *n, struct message *m);
/* Do long messages wait for room? */
bool match_may_grant(const struct node *n);
/* Follow a message for s until its buffer is free. */
void match_follow(struct message *m, struct send *s);
/* The message that s follows shall tell it no more. */
void match_unfollow(struct send *s);
/* Has the node ids that the program has told it to look after? */
bool match_ignores(const struct node *n);

/* --- for net/endpoint.h, with ctx = the node_system --- */
bool match_envelope(void *ctx, struct message *m, vtime now);
void match_sent(void *ctx, struct message *m, vtime now);
void match_arrived(void *ctx, struct message *m);
#endif
