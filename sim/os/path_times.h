/* path_times.h - where in its program a node's system time and waits fall: by path of calls (program_image.h)
 * and call of NX, for programs built with nxcc --profile.
 *
 * The sums over a node's struct path_time are its times.system and stats.idle. System time that falls while
 * the program computes, because a message comes or leaves, has one of its own: how far the program is then,
 * it does not tell. */
#ifndef OS_PATH_TIMES_H
#define OS_PATH_TIMES_H
#include "node/node.h"
#include "nx_api/contract/program_image.h"

struct path_time {
    const struct nxc_path *path; /* NULL: interrupts of a computing program */
    const char *call;
    vtime system, idle;
};

struct node_path_times {
    struct path_time *list;
    size_t count, room;
    const struct nxc_path *charged; /* the path of the call that is charged, of a name; NULL: the program's */
    const char *charged_call;
    struct nxc_path *made;    /* all paths that the program has asked for */
    struct nxc_path handlers; /* has called the handlers; without counts, and so the last */
};

/* The node's program has been loaded; is about to be unloaded. */
void path_times_begin(struct node *n);
void path_times_end(struct node *n);

/* The rest only if n->path_times. What is added is for the call that the program is in, on the path where the
 * program is. */
void path_times_add(struct node *n, vtime system, vtime idle);
void path_times_add_interrupt(struct node *n, vtime system);
/* The path where the program is; what is added from now on is for a call made on a path; for the program's
 * again. */
const struct nxc_path *path_times_now(const struct node *n);
void path_times_charge(struct node *n, const struct nxc_path *path, const char *call);
void path_times_charge_program(struct node *n);
/* A handler begins; returns the path of what it has interrupted, to be given back at its end. */
struct nxc_path *path_times_handler_begins(struct node *n);
void path_times_handler_ends(struct node *n, struct nxc_path *before);
#endif
