/* libc.h - the part of the C library that each node has for itself: streams, random numbers, strtok, ending. */
#ifndef NODE_LIBC_H
#define NODE_LIBC_H

struct node;
struct node_libc;

struct node_libc *
node_libc_new(struct node *n); /* streams: stdout line buffered to node_output(n, 1, ...), stderr
                                                    unbuffered to node_output(n, 2, ...), stdin: node 0 the simulator's,
                                                    others empty */
void *node_libc_data(struct node *n,
                     const char *name); /* address of the pointer behind DATA(name), NULL unknown */
void node_libc_end(
    struct node *n); /* on the node: runs its atexit functions, latest first, flushes its streams, and looks
                                       whether its heap is whole: else it fails */
void node_libc_flush(struct node *n); /* on the node: flushes its streams */
void node_libc_free(struct node *n);  /* off the node: closes what it left open, writes nothing */
#endif
