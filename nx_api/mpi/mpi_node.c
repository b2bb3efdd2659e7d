/* mpi_node.c - a process's beginning, and its waiting. See mpi_node.h. */
#include "nx_api/mpi/mpi_node.h"
#include <cpuid.h>
#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "nx_api/calls/call.h"
#include "nx_api/mpi/bells.h"
#include "nx_api/mpi/deadlock.h"
#include "nx_api/mpi/idle.h"
#include "nx_api/mpi/launcher.h"
#include "nx_api/mpi/mpi_end.h"
#include "nx_api/mpi/mpi_files.h"
#include "nx_api/mpi/mpi_long32.h"
#include "nx_api/mpi/mpi_mailbox.h"
#include "nx_api/mpi/quiet.h"
#include "nx_api/mpi/order_record.h"
#include "nx_api/mpi/run_summary.h"
#include "nx_api/mpi/stack.h"
#include "nx_api/mpi/signals.h"
#include "nx_api/mpi/sleep.h"
#include "nx_api/mpi/tick.h"
#include "nx_api/mpi/mpi_wire.h"

enum { MESSAGE_IDS = 500 };

static struct mpi_system all;
struct node mpi_me = {.sys = &all, .info = {-1, -1, -1, -1}};
static struct timespec began;

double mpi_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - began.tv_sec) + 1e-9 * (double)(now.tv_nsec - began.tv_nsec);
}

/* --- longs --- */

/* mpi_long32.c defines another, which precedes this one. */
__attribute__((weak)) int mpi_long_bytes = sizeof(long);

size_t node_long_bytes(const struct node *n)
{
    (void)n;
    return (size_t)mpi_long_bytes;
}

long node_get_long(const struct node *n, const long *array, size_t i)
{
    (void)n;
    return mpi_long_bytes == sizeof(int32_t) ? ((const int32_t *)array)[i] : array[i];
}

void node_put_long(const struct node *n, long *array, size_t i, long value)
{
    (void)n;
    if (mpi_long_bytes == sizeof(int32_t))
        ((int32_t *)array)[i] = (int32_t)value;
    else
        array[i] = value;
}

/* --- calls --- */

static void heed(struct node *n)
{
    if (n->killed && !n->over)
        mpi_end_here(n);
}

static bool run_handlers(struct node *n)
{
    bool any = false;
    while (mpi_mailbox_run_handler(n))
        any = true;
    return any;
}

static inline void begin_call(struct node *n, const char *call)
{
    n->saved_errno = errno;
    n->call.name = call;
    n->call.caller = stack_caller(__builtin_frame_address(0));
    n->call.has_type = false;
}

void node_enter(struct node *n, const char *call)
{
    begin_call(n, call);
    wire_progress(n);
    heed(n);
}

/* Takes in what has come if that is due: loops without polls make such calls, too. */
void node_enter_early(struct node *n, const char *call)
{
    begin_call(n, call);
    if (nxc_due && bell_take())
        wire_progress(n);
    heed(n);
}

void node_enter_asking(struct node *n, const char *call)
{
    node_enter(n, call);
}

void node_answers(struct node *n, bool yes)
{
    (void)n, (void)yes;
}

void node_leave(struct node *n)
{
    run_handlers(n);
    n->call.name = NULL;
    errno = n->saved_errno;
}

void node_order(struct node *n)
{
    (void)n; /* node_enter has taken in what has come */
}

/* The program rests in its wait. *since: when this began, less than 0: it begins now. */
static void rest(struct node *n, double *since)
{
    bell_sleep(50000);
    if (n->ready == sleep_is_over || n->ready == files_are_moved)
        return;
    if (*since < 0)
        *since = mpi_seconds();
    n->since = *since;
    if (deadlock_look(n, *since))
        mpi_end_deadlocked(n);
}

/* Polls of a wait: from which on the clock is read, the processor yielded, the node asleep. */
enum { LOOKING = 8, YIELDING = 2000, SLEEPING = 20000 };

/* Do polls take longer than on a processor of the node's own? Each yield takes milliseconds if other programs
 * are on the processor. */
static bool is_shared(unsigned polls, bool yields)
{
    static const double LONG_S = 0.002, POLL_S = 1e-6;
    static double begun;
    static bool shared;
    if (polls == LOOKING)
        begun = mpi_seconds();
    if (polls <= LOOKING)
        shared = false;
    else if (yields || polls % LOOKING == 0)
        shared = mpi_seconds() - begun > LONG_S + polls * POLL_S;
    return shared;
}

/* Polls without a pause at first, then yields the processor, and at last, after some milliseconds, sleeps
 * till somebody rings; on a processor that others use it sleeps sooner. To be woken takes long where the
 * processor sleeps, too. */
static void pause_after(struct node *n, unsigned polls, double *since)
{
    const bool yields = polls > (idle_yields ? LOOKING : YIELDING);
    if (polls > SLEEPING || is_shared(polls, yields))
        rest(n, since);
    else if (yields)
        sched_yield();
}

/* Takes in what has come, and runs handlers. False: nothing has come. */
static bool progress(struct node *n)
{
    bool any = wire_progress(n);
    heed(n);
    if (run_handlers(n)) {
        any = true;
        tick_rest(true); /* a handler may have waited, too */
    }
    return any;
}

void node_wait(struct node *n, bool (*ready)(struct node *, void *), void *arg)
{
    bool (*outer)(struct node *, void *) = n->ready; /* of the call that a handler has interrupted */
    void *outer_for = n->ready_for;
    double since = -1;
    n->ready = ready, n->ready_for = arg;
    tick_rest(true);
    SUMMARY(wait);
    for (unsigned polls = 0;; polls++) {
        bool any = progress(n);
        if (ready(n, arg))
            break;
        if (any)
            polls = 0;
        pause_after(n, polls, &since);
    }
    SUMMARY(go_on, n);
    tick_rest(false);
    n->ready = outer, n->ready_for = outer_for;
}

/* A poll of the program has found nxc_due set: tick.c. */
void nxc_preempt(void);
void nxc_preempt(void)
{
    struct node *n = node_self();
    int saved = errno;
    bell_take();
    if (!n->over) {
        wire_progress(n);
        heed(n);
        run_handlers(n);
    }
    errno = saved;
}

/* --- for calls: contract/backend.h --- */

void nx_begins_call(struct node *n)
{
    order_calls += !n->in_handler;
}

void nx_about(struct node *n, long what)
{
    n->call.type = what;
    n->call.has_type = true;
}

void nx_awaits(struct node *n, const struct receive *r, const struct send *s)
{
    (void)n, (void)r, (void)s;
}

void nx_found_nothing(struct node *n, const struct selector *select)
{
    (void)n, (void)select;
}

void nx_spend_call(struct node *n)
{
    (void)n; /* time is real */
}

void nx_spend_kernel(struct node *n)
{
    (void)n;
}

struct own_calls *nx_own_calls(struct node *n)
{
    return &n->own;
}

struct node_error *nx_last_error(struct node *n)
{
    return &n->error;
}

uint32_t nx_message_ids(const struct node *n)
{
    (void)n;
    return MESSAGE_IDS;
}

long nx_check_way(struct node *n, long node)
{
    (void)n, (void)node;
    return 0;
}

bool nx_goes_at_once(const struct node *n, const struct outgoing *o)
{
    (void)n, (void)o;
    return true;
}

void nx_send(struct node *n, const struct outgoing *o, struct send *s)
{
    const struct wire_head head = {WIRE_DATA, (int32_t)o->type, (int32_t)n->pid, 0};
    SUMMARY(send, n, o->node, (size_t)o->len);
    wire_send(n, o->node, head, o->buf, (size_t)o->len);
    if (s)
        s->done = true;
}

void nx_flush(struct node *n, long node, int64_t typesel)
{
    if (node == ALL_NODES || node == n->id)
        mpi_mailbox_flush(n, typesel);
    if (node != n->id)
        wire_send(n, node, (struct wire_head){WIRE_FLUSH, (int32_t)typesel, 0, 0}, NULL, 0);
}

/* --- beginning --- */

extern unsigned nxc_saved;

/* The parts of the processor's state that a poll has to save: those of x87, SSE, AVX, AVX-512 that this
 * processor has. */
static unsigned state_to_save(void)
{
    enum { OSXSAVE = 1 << 27, WANTED = 0xe7 };
    unsigned a, b, c, d, low, high;
    if (!__get_cpuid(1, &a, &b, &c, &d) || !(c & OSXSAVE))
        return 0;
    __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    (void)high;
    return low & WANTED;
}

static void begin(struct node *n, int *argc, char ***argv)
{
    clock_gettime(CLOCK_MONOTONIC, &began);
    bool rung = wire_begin(n, argc, argv);
    clock_gettime(CLOCK_MONOTONIC, &began);
    launcher_check(n);
    n->ends = calloc(n->sys->count, sizeof *n->ends);
    n->mailbox = mpi_mailbox_new();
    quiet_begin(n);
    record_begin(n);
    summary_begin(n);
    nxc_saved = state_to_save();
    signals_begin();
    if (!n->ends || !tick_start(rung))
        node_fail(n, "the node cannot start: %s", strerror(errno));
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    mpi_end_begin();
    errno = 0;
}

__attribute__((weak)) int mpi_call_main(main_function *program, int argc, char **argv, char **envp)
{
    return program(argc, argv, envp);
}

/* nxcc links with --wrap=main. */
int __real_main(int argc, char **argv, char **envp);
__attribute__((visibility("default"))) int __wrap_main(int argc, char **argv, char **envp);
int __wrap_main(int argc, char **argv, char **envp)
{
    struct node *n = node_self();
    begin(n, &argc, &argv);
    n->exit_code = mpi_call_main(__real_main, argc, argv, envp);
    n->returned = true;
    return 0;
}
