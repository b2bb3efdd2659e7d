/* crash.h - a node program's fault (SIGSEGV and its kin) caught and told as the node's error.
 *
 * While a guard is set, a fault on a node's stack writes a report into the guard and jumps to it; any other
 * fault takes the usual course. Signal handlers are given nothing but the signal, so the guard in force is
 * the one piece of thread-local state in the simulator. */
#ifndef MACHINE_CRASH_H
#define MACHINE_CRASH_H
#include <setjmp.h>
#include "node/system.h"

struct crash_guard {
    struct node_system *sys;
    sigjmp_buf jump;   /* to be set by the caller: if (sigsetjmp(g->jump, 1)) it crashed */
    struct node *node; /* that crashed */
    int signal;
    uintptr_t address; /* that could not be used, for SIGSEGV and SIGBUS */
    uintptr_t top;     /* word on top of the stack */
    uintptr_t frames[24];
    int depth;
    void *stack; /* the handler's own */
};

void crash_watch(struct crash_guard *g, struct node_system *sys);
void crash_unwatch(struct crash_guard *g);
/* What happened, for the user; malloc'd. */
char *crash_report(const struct crash_guard *g);
#endif
