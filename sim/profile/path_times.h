/* path_times.h - a node's system time and waits: by path of calls (program_image.h)
 * and call of NX, for programs built with nxcc --profile. An observer (os/observer.h) adds them up.
 *
 * The sums over a node's struct path_time are its times.system and stats.idle. System time that falls while
 * the program computes, because a message comes or leaves, has one of its own: how far the program is then,
 * it does not tell. */
#ifndef PROFILE_PATH_TIMES_H
#define PROFILE_PATH_TIMES_H
#include "node/node.h"
#include "nx_api/contract/program_image.h"
#include "os/observer.h"

struct path_time {
    const struct nxc_path *path; /* NULL: interrupts of a computing program */
    const char *call;
    vtime system, idle;
};

struct node_path_times {
    struct observer observer; /* first */
    struct path_time *list;
    size_t count, room;
    const struct nxc_path *deferred[DEFERRED_MOST]; /* on which each of node.calls was made */
    const struct nxc_path *charged; /* the path of the call that is charged, of a name; NULL: the program's */
    const char *charged_call;
    struct nxc_path *made;        /* all paths that the program has asked for */
    struct nxc_path *interrupted; /* on which the program was when the handler that runs has begun */
    struct nxc_path handlers;     /* has called the handlers; without counts, and so the last */
};

/* The node's program has been loaded; is about to be unloaded. */
void path_times_begin(struct node *n);
void path_times_end(struct node *n);
/* NULL: the program was built without --profile. */
const struct node_path_times *path_times_of(const struct node *n);
#endif
