/* libc.h - the part of the C library that each node has for itself: streams, random numbers, strtok, ending.
 */
#ifndef NODE_LIBC_H
#define NODE_LIBC_H

struct node;
struct node_libc;

/* Streams: stdout line buffered, stderr unbuffered, both to the run's output; stdin: node 0 has the
 * simulator's, the others' are empty. */
struct node_libc *node_libc_new(struct node *n);
/* The address of the pointer behind DATA(name); NULL unknown. */
void *node_libc_data(struct node *n, const char *name);
/* On the node: runs its atexit functions, latest first, flushes its streams, and fails if its heap is
 * damaged. */
void node_libc_end(struct node *n);
void node_libc_flush(struct node *n); /* on the node: flushes its streams */
void node_libc_free(struct node *n);  /* off the node: closes what it left open, writes nothing */
#endif
