/* isolate.h - touchstone run --isolate: only the node that runs may write to its memory; the others' can be
 * read. A program that writes through a pointer into another node's memory crashes there. Each switch to
 * another node costs some calls of the host's kernel, six or so; and programs run on one thread. */
#ifndef NODE_ISOLATE_H
#define NODE_ISOLATE_H
#include "node/system.h"

/* A node has been made: nobody writes to its memory any more before it runs. */
void isolate_made(struct node *n);
/* n is going to run. */
void isolate_run(struct node *n);
/* Another is going to run within a call of the one that runs, which is returned, and may write beside it;
 * then that goes on. */
struct node *isolate_keep(struct node_system *s);
void isolate_back_to(struct node_system *s, struct node *caller);
#endif
