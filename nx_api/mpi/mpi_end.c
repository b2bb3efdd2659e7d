/* mpi_end.c - see mpi_end.h. */
#include "nx_api/mpi/mpi_end.h"
#include <locale.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>
#include "nx_api/calls/call.h"
#include "nx_api/mpi/deadlock.h"
#include "nx_api/mpi/io_jobs.h"
#include "nx_api/mpi/mpi_node.h"
#include "nx_api/mpi/mpi_wire.h"
#include "nx_api/mpi/quiet.h"
#include "nx_api/mpi/order_record.h"
#include "nx_api/mpi/run_summary.h"
#include "nx_api/mpi/where.h"

enum { PATIENCE_S = 5 };

static pid_t process; /* of the program itself, not of its children */
static bool deadlocked;

void mpi_end_numbers(void)
{
    uselocale(newlocale(LC_ALL_MASK, "C", NULL));
}

static void nap(long ns)
{
    nanosleep(&(struct timespec){.tv_nsec = ns}, NULL);
}

/* A token of quiet.h must not be under way when MPI ends. */
static void settle(struct node *n)
{
    while (!wire_all_are_here(quiet_settle(n)) || !wire_is_empty()) {
        wire_progress(n);
        nap(1000);
    }
    wire_end();
}

static void kill_others(struct node *n)
{
    wire_send(n, ALL_NODES, (struct wire_head){.kind = WIRE_KILL}, NULL, 0);
}

static void say_end(struct node *n, int status)
{
    n->over = true;
    n->since = mpi_seconds();
    n->ends[n->id].ended = true;
    n->ended++;
    record_end(n);
    SUMMARY(end, n, status);
    wire_send(n, ALL_NODES, (struct wire_head){WIRE_END, status, (int32_t)n->pid, 0}, NULL, 0);
}

/* Tells all nodes of this process's end and waits for theirs; after `patience` seconds (0: never) aborts
 * them. If the others wait for ever, ends the process. */
static void finish(struct node *n, int status, double patience)
{
    bool deadlock = false;
    mpi_end_numbers();
    io_settle_all();
    say_end(n, status);
    for (long pause = 1000; n->ended < n->sys->count || !wire_is_empty();) {
        if (wire_progress(n))
            pause = 1000;
        nap(pause);
        pause += pause < 1000000 ? pause / 4 : 0;
        if (patience > 0 && mpi_seconds() - n->since > patience)
            wire_abort(status);
        if (!deadlock && deadlock_look(n, n->since)) {
            deadlock = true;
            kill_others(n);
        }
    }
    if (n->id == 0)
        SUMMARY(write, n, deadlock || deadlocked);
    settle(n);
    if (deadlock)
        syscall(SYS_exit_group, DEADLOCK_STATUS);
}

/* The program has called exit or _exit. A status other than 0 ends all nodes, so that none waits in vain. */
static void exits(struct node *n, int status)
{
    if (n->over || getpid() != process)
        return;
    if (status == 0) {
        finish(n, 0, 0);
        return;
    }
    mpi_end_numbers();
    fprintf(stderr, "nx: node %ld, at %.6f s: exit(%d), which ends the program on all nodes\n", n->id,
            mpi_seconds(), status);
    SUMMARY(fail);
    kill_others(n);
    finish(n, status, PATIENCE_S);
}

/* Runs when main has returned, too. What main returns is no exit status. */
static void at_exit(int status, void *unused)
{
    struct node *n = node_self();
    (void)unused;
    fflush(NULL);
    if (n->returned && !n->over)
        finish(n, (int)n->exit_code, 0);
    exits(n, status);
}

_Noreturn void node__exit(int status) NX_EXPORT("_exit");
_Noreturn void node__exit(int status)
{
    exits(node_self(), status);
    syscall(SYS_exit_group, status);
    __builtin_unreachable();
}

_Noreturn void mpi_end_here(struct node *n)
{
    fflush(NULL);
    finish(n, 0, n->killed_alone ? 0 : PATIENCE_S);
    node__exit(0);
}

_Noreturn void node_fail(struct node *n, const char *fmt, ...)
{
    va_list ap;
    char message[512], head[80];
    static struct safe_text text;
    mpi_end_numbers();
    va_start(ap, fmt);
    vsnprintf(message, sizeof message, fmt, ap);
    va_end(ap);
    fflush(stdout);
    snprintf(head, sizeof head, "nx: node %ld, at %.6f s: ", n->id, mpi_seconds());
    safe_append(&text, head);
    safe_append(&text, message);
    safe_append(&text, "\n");
    where_append(&text, NULL);
    safe_write(&text);
    if (n->over || !n->ends)
        wire_abort(1);
    fflush(NULL);
    SUMMARY(fail);
    kill_others(n);
    finish(n, 1, PATIENCE_S);
    node__exit(1);
}

_Noreturn void mpi_end_deadlocked(struct node *n)
{
    deadlocked = true;
    fflush(NULL);
    kill_others(n);
    finish(n, DEADLOCK_STATUS, PATIENCE_S);
    node__exit(DEADLOCK_STATUS);
}

void mpi_end_begin(void)
{
    process = getpid();
    on_exit(at_exit, NULL);
}
