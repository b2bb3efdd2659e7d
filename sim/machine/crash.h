/* crash.h - a node program's fault (SIGSEGV and its kin) caught and told as the node's error.
 *
 * Each thread that runs programs watches, with a guard of its own. A fault while a node's fiber runs writes
 * down what is known, in n->crash, and ends the fiber; any other fault takes the usual course. Where the
 * program has called a library, GCC's unwinder (libgcc) finds the way back to it: libraries have no frame
 * pointers. Signal handlers are given nothing but the signal: so the guard in force and the fiber that runs
 * are what the simulator has of thread-local state. */
#ifndef MACHINE_CRASH_H
#define MACHINE_CRASH_H
#include "node/system.h"

struct node_crash {
    int signal;
    uintptr_t address; /* that could not be used, for SIGSEGV and SIGBUS */
    uintptr_t top;     /* word on top of the stack */
    bool in_library; /* frames[0] is there, and frames[1], if there is one, where the program had called it */
    uintptr_t frames[24];
    int depth;
};

struct crash_guard;

/* For the process: faults come to us, until crash_ignore(). */
void crash_catch(void);
void crash_ignore(void);
/* For the calling thread. */
struct crash_guard *crash_watch(void);
void crash_unwatch(struct crash_guard *g);
/* n's program has just crashed on the calling thread: what is known of it is the node's to keep, malloc'd. */
void crash_keep(struct node *n);
/* What happened, for the user; malloc'd. */
char *crash_report(const struct node *n);
#endif
