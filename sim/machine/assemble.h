/* assemble.h - makes nodes of their parts, and takes them apart. */
#ifndef MACHINE_ASSEMBLE_H
#define MACHINE_ASSEMBLE_H
#include "node/system.h"

/* Makes a node with its program loaded; node_start() starts it. Returns NULL and sets *error (malloc'd) if
 * the program cannot be loaded. The caller ends the node by node_delete(). */
struct node *node_new(struct node_system *sys, uint32_t id, const struct node_image *img, int argc,
                      char **argv, char **envp, char **error);
/* Starts the node's program at time t, or later in a run with another timing than usual. */
void node_start(struct node *n, vtime t);
/* Makes a node without a program, which counts as ended. Messages that come wait for a program to be
 * loaded. */
struct node *node_new_empty(struct node_system *sys, uint32_t id);
/* As node_new(), for the host at its address. */
struct node *node_new_host(struct node_system *sys, uint32_t address, const struct node_image *img, int argc,
                           char **argv, char **envp, char **error);
/* What the node's program does is recorded, if the run's trace (trace/recorder.h) wants the node. New
 * nodes are so from the start. */
void node_record(struct node *n);
/* Makes n, a new node, the successor of `before`, whose program has ended, at time t: n continues the
 * accounts of `before` and gets the messages that wait. `before` keeps only what events may still refer to.
 */
void node_succeed(struct node *n, struct node *before, vtime t);
/* Frees a node, for which no event is committed any more. NULL: does nothing. */
void node_delete(struct node *n);
#endif
