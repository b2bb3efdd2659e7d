/* cube.h - what a host program does with nodes: it gets a cube of them, loads programs, waits for their
 * ends, kills what is left, and gives the cube back.
 *
 *     getcube        load           (ends)        load          killcube, relcube
 *        empty ------> runs -------> ended ------> runs -------> ended
 *
 * A node on which a program is loaded again is a new struct node: its memory, image and streams are new,
 * and it continues the accounts of the old node (node_succeed). The old node is kept, stripped, as long as
 * the machine, since events may still refer to it. A machine without a host program has no cube: its nodes
 * are loaded when it is made.
 *
 * The calls from cube_get on are made by the host program, inside one of its NX calls. They return 0, or -1
 * with the error that node_error() sets. */
#ifndef MACHINE_CUBE_H
#define MACHINE_CUBE_H
#include "node/system.h"

struct cube_options {
    uint32_t most;       /* nodes of the machine; a cube is the first so many of them */
    bool given;          /* the host program has all nodes from the start, without getcube */
    const char *program; /* the nodes' program on the command line; NULL: none */
    const char *host;    /* path of the host program; node programs are looked for in its folder */
    char **envp;         /* the environment of node programs */
};

/* Makes sys->cube, of which there is none yet, and sys->nodes without programs. */
void cube_new(struct node_system *sys, const struct cube_options *options);
void cube_free(struct cube *c);

/* Gets a cube of a type (cube_type.h); NULL or "" is all nodes. A host has one cube at a time. */
long cube_get(struct node *host, const char *name, const char *type);
/* Releases the cube, and kills its programs. name NULL or "": the cube, whatever its name. */
long cube_release(struct node *host, const char *name);
long cube_attach(struct node *host, const char *name);
uint32_t cube_most(const struct cube *c);    /* nodes of the largest cube so far */
const char *cube_name(const struct cube *c); /* NULL: no cube */

/* Loads a program on a node, or on all if node is -1, and starts it as process pid. */
long cube_load(struct node *host, const char *path, long node, long pid);
/* Ends the program of a node, or all programs if node is -1, except the caller's own. flush: throws away
 * all messages on their way to these nodes. */
void cube_kill(struct node *caller, long node, bool flush);
/* May the host send to a node, or to all if node is -1? Returns 0, or -1 with the error if there is no
 * cube, or no program to receive the message. */
long cube_check_send(struct node *host, long node);
#endif
