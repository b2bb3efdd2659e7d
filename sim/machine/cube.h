/* cube.h - what a host program does with nodes: it gets a cube of them, loads programs on it, waits for their
 * ends, kills what is left, and gives the cube back.
 *
 *     getcube        load           (ends)        load          killcube, relcube
 *        empty ------> runs -------> ended ------> runs -------> ended
 *
 * A node on which a program is loaded again is a new struct node: its memory, image and output are new, its
 * books go on (node_succeed). The old one is kept, empty, as long as the machine, for events that still name
 * it. A machine without a host program has no cube: its nodes are loaded when it is made.
 *
 * The calls below are made by the host program, from one of its NX calls; the errors are node_error's: -1.
 */
#ifndef NODE_CUBE_H
#define NODE_CUBE_H
#include "node/system.h"

struct cube_options {
    uint32_t most;       /* nodes of the machine; cubes are of the first of them */
    bool given;          /* the host program need not get it: it has all of them from the start */
    const char *program; /* for the nodes, from the command line; NULL: none */
    const char *host;    /* path of the host program: node programs are looked for beside it */
    char **envp;         /* of node programs */
};

/* Makes sys->cube, and sys->nodes without programs. */
void cube_new(struct node_system *sys, const struct cube_options *options);
void cube_free(struct cube *c);

/* Type: cube_type.h; NULL or "" is all that there are. One cube at a time. */
long cube_get(struct node *host, const char *name, const char *type);
/* name NULL or "": whatever it is called. */
long cube_release(struct node *host, const char *name);
long cube_attach(struct node *host, const char *name);
uint32_t cube_most(const struct cube *c);    /* nodes of the largest cube that there has been */
const char *cube_name(const struct cube *c); /* NULL: no cube */

/* Loads a program on a node, or with -1 on all, and starts it. */
long cube_load(struct node *host, const char *path, long node, long pid);
/* Ends the program of a node, or with -1 of all, except the caller's own; flush: with all messages on their
 * way to it. */
void cube_kill(struct node *caller, long node, bool flush);
/* May the host send there? 0, or -1 with the error when there is no cube or nobody to get it. */
long cube_check_send(struct node *host, long node);
#endif
