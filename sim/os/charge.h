/* charge.h - the account of a node's time: what goes to its operating system, and to waiting. */
#ifndef OS_CHARGE_H
#define OS_CHARGE_H
#include "net/endpoint.h"
#include "node/node.h"

/* The time that this node's system takes for what takes an ordinary node's t. Charges a time to a task. */
vtime node_system_time(const struct node *n, vtime t);
void node_account(struct node *n, enum node_task task, vtime t);
/* Takes back a charge, of a call that is rolled back. */
void charge_undo(struct node *n, enum node_task task, vtime t);

/* The program sends or receives until t: a message that comes meanwhile finds it in the kernel. */
static inline void charge_in_kernel(struct node *n, vtime t)
{
    n->in_kernel = t;
}
/* The program has sent so many messages, of so many bytes in all. */
static inline void charge_sent(struct node *n, uint64_t messages, uint64_t bytes)
{
    n->stats.sent += messages, n->stats.sent_bytes += bytes;
}
/* What a message that comes takes besides, to enter a kernel below NX: nothing if node or system are in it.
 * Calls are not deferred on such machines: whether the program is in one is known at each moment. */
__attribute__((noinline, cold)) vtime charge_entry(struct node_system *sys, uint32_t node, vtime at);
/* The program begins to wait. The program has waited until t. */
void charge_wait_begins(struct node *n);
void charge_wait_ends(struct node *n, vtime t);

/* All that a node's program has spent so far: computing, idle and system. */
vtime charge_sum(const struct node *n);
/* Do the sums of struct node_times and node_stats agree, for a node that has ended? */
bool charge_adds_up(const struct node *n);

/* --- for net/endpoint.h, with ctx = the node_system --- */
vtime node_work(void *ctx, uint32_t node, enum protocol_task task, vtime at, vtime t);
void node_move(void *ctx, uint32_t node, enum protocol_task task, vtime at, vtime t);
#endif
