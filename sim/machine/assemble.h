/* assemble.h - the making of nodes from their parts, and their taking apart. */
#ifndef MACHINE_ASSEMBLE_H
#define MACHINE_ASSEMBLE_H
#include "node/system.h"

/* Makes a node with its program loaded, ready to start at time 0. NULL with *error set. */
struct node *node_new(struct node_system *sys, uint32_t id, const struct node_image *img, int argc,
                      char **argv, char **envp, char **error);
void node_delete(struct node *n);
/* The same without a program: it has ended before it began. Messages wait for the one to be loaded. */
struct node *node_new_empty(struct node_system *sys, uint32_t id);
/* The host, at its address. */
struct node *node_new_host(struct node_system *sys, uint32_t address, const struct node_image *img, int argc,
                           char **argv, char **envp, char **error);
/* Makes n, a new node, the one that comes after `before`, whose program has ended: its books go on in n, and
 * n gets the messages that wait. Time is t. */
void node_succeed(struct node *n, struct node *before, vtime t);
#endif
