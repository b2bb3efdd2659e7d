/* debug_stop.h - stops in a debugger: touchstone run --gdb NODE [--at TIME], and a deadlock.
 *
 * A stop at a time is a limit of virtual time that ends nothing: the machine commits all that happens before
 * it, and each program has come to its first poll or call at or behind it. Then touchstone_stops(), where the
 * debugger has a breakpoint, is called on the node's thread; and the run goes on with its own limit. */
#ifndef MACHINE_DEBUG_STOP_H
#define MACHINE_DEBUG_STOP_H
#include "node/system.h"

struct debug_stop_options {
    bool wanted;
    bool host;     /* the host program; else: */
    uint32_t node; /* its number */
    vtime time;    /* 0: at the start of main */
};

struct debug_stop {
    struct debug_stop_options options;
    bool pending;
    vtime limit; /* the run's own, while the schedule has the stop's */
};

/* Before the run, when all nodes have been made. *stop and *options last as long as the machine. */
void debug_stop_begin(struct node_system *s, struct debug_stop *stop,
                      const struct debug_stop_options *options);
/* Programs have been loaded, and are going to start: tells the debugger, and stops if that is asked for. */
void debug_stop_loaded(struct node_system *s);
/* When nothing is left to happen but what comes after the schedule's limit of virtual time: stops if the
 * limit is the stop's, and sets the run's own. False: it is the run's own. */
bool debug_stop_at_limit(struct node_system *s);
/* Behind the run: says if it ended before the stop, and stops in a deadlock, while all nodes are where they
 * wait. */
void debug_stop_end(struct node_system *s, bool deadlock);

/* Does nothing: debuggers have a breakpoint here (cli/gdb_start.c). resume: where in the program it goes on,
 * NULL: nowhere. function: the function that is there, "": not known. in_call: when a call that it is in has
 * returned. */
void touchstone_stops(const void *resume, const char *function, bool in_call);
#endif
