/* memory.h - the account of a node's memory. What counts against it (machine file: memory_mb): the operating
 * system, the program's image, its stack, its heap up to the highest block in use, and unexpected messages in
 * system buffers. */
#ifndef OS_MEMORY_H
#define OS_MEMORY_H
#include "node/node.h"

/* Bytes of the node's memory in use, with the heap as it was in the last call; and all that a program may
 * use. */
size_t node_memory_used(const struct node *n);
size_t node_memory_limit(const struct node *n);
/* The node's whole memory; and of it what an allocation finds in use, with the operating system. */
size_t node_memory_all(const struct node *n);
size_t node_memory_claimed(const struct node *n);
/* Notes the high-water mark after a message has come. */
void node_memory_changed(struct node *n);
/* In a call: from now on messages are weighed against all of the program's heap, and, unless the call may be
 * deferred, the heap against all messages. */
void node_memory_settle(struct node *n);
/* The program's memory now; and, for messages, as it was in a call that has been committed. */
struct memory_mark node_memory_now(const struct node *n);
void node_memory_was(struct node *n, struct memory_mark m);

/* --- for guest/heap.h, with ctx = the node --- */

/* Is there room for a heap of so many bytes? */
int memory_has_room(void *ctx, size_t bytes);
/* The heap has grown or shrunk to so many bytes. */
void memory_heap_is(void *ctx, size_t used);
#endif
