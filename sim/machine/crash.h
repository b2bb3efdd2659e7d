/* crash.h - catches a node program's fault (SIGSEGV and similar signals), and reports it as the node's
 * error.
 *
 * Each thread that runs programs has a guard. At a fault while a node's fiber runs, the signal handler
 * notes what is known in cold->crash and ends the fiber; any other fault ends the process, with a line. If
 * the program has called a library function, GCC's unwinder (libgcc) finds the call, since libraries keep no
 * frame pointers. A signal handler is given nothing but the signal; therefore a thread's running fiber is
 * thread-local, and its guard is the handler's stack. */
#ifndef MACHINE_CRASH_H
#define MACHINE_CRASH_H
#include <signal.h>
#include "node/system.h"

struct node_crash {
    int signal, code; /* code: the signal's si_code */
    uintptr_t
        address;   /* which the program may not use; of SIGSEGV and SIGBUS. Of SIGSYS: the call's number */
    uintptr_t top; /* the word on top of the stack */
    /* frames[0] is in a library; frames[1], if known, is where the program called the library */
    bool in_library;
    bool lost_thread;     /* %fs no longer pointed to the thread's variables */
    uintptr_t frames[24]; /* where it crashed, then the return addresses of the calls under way */
    int depth;            /* frames known, at least 1 */
};

struct crash_guard;

/* From here on, the process's faults come here. */
void crash_catch(void);
/* From another signal's handler: if the thread's program was computing, notes in cold->crash where, and ends
 * its fiber as a fault does; else returns. */
void crash_end_computing(int signal, siginfo_t *info, void *context);
/* Is cold->crash a fault, rather than the end that crash_end_computing() made? */
bool crash_is_fault(const struct node *n);
/* Makes the calling thread's guard; crash_unwatch() frees it. */
struct crash_guard *crash_watch(void);
void crash_unwatch(struct crash_guard *g);
/* The same for makers of threads. */
void *crash_thread_begins(void);
void crash_thread_ends(void *guard);
/* To be called on the thread on which n's program has just crashed, before another program runs there:
 * copies cold->crash, which was the guard's. The node owns the copy (malloc'd). */
void crash_keep(struct node *n);
/* Describes cold->crash for the user; malloc'd. */
char *crash_report(const struct node *n);
#endif
