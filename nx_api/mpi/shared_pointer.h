/* shared.h - pointers that nodes share into files (I/O modes 1 to 3). Pointers have numbers, the same on all nodes.
 *
 *   M_LOG     node 0 keeps the pointer, and lends it to one node at a time, first come first served
 *   M_SYNC    the pointer goes from node to node, in their order, round and round
 *   M_RECORD  every node knows where a round begins; node 0 looks whether all give the same length */
#ifndef MPI_SHARED_H
#define MPI_SHARED_H
#include "backend_node.h"

/* On node 0: an M_SYNC pointer begins its way. */
void shared_start(struct node *n, int32_t number, int64_t place);
/* Wait for pointer `number`, which is at `begin` if nobody has had it yet; its place. */
int64_t shared_borrow(struct node *n, int mode, int32_t number, int64_t begin);
/* The pointer is at `place` now; it goes on to others. */
void shared_give_back(struct node *n, int mode, int32_t number, int64_t place);
/* M_RECORD: this node gives `bytes` in a round; an error ends the program. */
void shared_check(struct node *n, int32_t number, int64_t round, int64_t bytes);
/* A message of another node's library. */
void shared_message(struct node *n, int source, int32_t what, int32_t number, const void *bytes);
#endif
