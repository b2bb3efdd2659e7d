/* isolate.h - touchstone run --isolate: a program can write to its own node's memory only, and read that of
 * others. A program that writes through a pointer into another node's memory crashes there. Each switch to
 * another node costs about six calls of the host's kernel, and programs run on one thread. */
#ifndef NODE_ISOLATE_H
#define NODE_ISOLATE_H
#include "node/system.h"

/* A node has been made: its memory is closed until it runs. */
void isolate_made(struct node *n);
/* n is going to run. */
void isolate_run(struct node *n);
/* Another node is going to run within a call of the one that runs: returns the latter, whose memory stays
 * open. Then the latter goes on. */
struct node *isolate_keep(struct node_system *s);
void isolate_back_to(struct node_system *s, struct node *caller);
#endif
