/* shared_pointer.h - file pointers that nodes share (I/O modes 1 to 4). A pointer has the same number on all
 * nodes.
 *
 *   M_LOG     node 0 keeps the pointer, and lends it to one node at a time, first come first served
 *   M_SYNC    the pointer goes from node to node, in their order, round and round
 *   M_RECORD  every node knows where a round begins; node 0 checks that all give the same length
 *   M_GLOBAL  node 0 checks as in M_RECORD; in a write the pointer goes round, so that node 0 writes first */
#ifndef MPI_SHARED_H
#define MPI_SHARED_H
#include "backend_node.h"

/* On node 0: a new M_SYNC pointer is here. */
void shared_start(struct node *n, int32_t number, int64_t offset);
/* Waits for a pointer and returns its offset, which is `begin` before its first use. */
int64_t shared_borrow(struct node *n, int mode, int32_t number, int64_t begin);
/* Hands the pointer, which is at `offset` now, to the next node. */
void shared_give_back(struct node *n, int mode, int32_t number, int64_t offset);
/* Says that this node moves `bytes` in a round. Ends the program if another node moves more or fewer. */
void shared_check(struct node *n, int32_t number, int64_t round, int64_t bytes);
/* For reports: is this the condition of a wait for a shared pointer? */
bool shared_is_awaited(bool (*ready)(struct node *n, void *arg));
/* Handles a message of another node's library. */
void shared_message(struct node *n, int source, int32_t what, int32_t number, const void *bytes);
#endif
