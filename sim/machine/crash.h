/* crash.h - a node program's fault (SIGSEGV and its kin) caught and told as the node's error.
 *
 * Each thread that runs programs watches, with a guard of its own. A fault while it runs one (crash_run) writes down what
 * is known and ends the run; any other fault takes the usual course. Signal handlers are given nothing but the signal, so
 * the guard in force is the one piece of thread-local state in the simulator. */
#ifndef MACHINE_CRASH_H
#define MACHINE_CRASH_H
#include "node/system.h"

struct node_crash {
    int signal;
    uintptr_t address; /* that could not be used, for SIGSEGV and SIGBUS */
    uintptr_t top;     /* word on top of the stack */
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
/* Runs n's program on a thread that watches, until it yields. False: it has crashed, and n->crash is set. */
bool crash_run(struct node *n);
/* What happened, for the user; malloc'd. */
char *crash_report(const struct node *n);
#endif
