/* machine_run.c - runs a machine (machine.h): starts its threads, polls what may end the run from outside,
 * and settles the nodes' accounts at the end. */
#include <assert.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "guest/trace.h"
#include "kernel/hostclock.h"
#include "lp/engine.h"
#include "machine/crash.h"
#include "machine/machine.h"
#include "machine/verdict.h"
#include "net/protocol_record.h"
#include "os/end.h"
#include "os/first_failure.h"
#include "os/record.h"

/* Signals that end a run. They are blocked during the run, and polled now and then, so that the nodes'
 * output is not lost and the user is told where each node is. */
static const int ENDING[] = {SIGINT, SIGTERM, SIGHUP};
enum { ENDINGS = sizeof ENDING / sizeof *ENDING };

/* Those of the signals that are not ignored, as they are under nohup. */
static sigset_t ending_signals(void)
{
    sigset_t set;
    sigemptyset(&set);
    for (int i = 0; i < ENDINGS; i++) {
        struct sigaction now;
        if (sigaction(ENDING[i], NULL, &now) == 0 && now.sa_handler != SIG_IGN)
            sigaddset(&set, ENDING[i]);
    }
    return set;
}

/* Ends the run if the limit of host time is reached, or a signal asks for its end. Results up to then do
 * not depend on either. */
static void poll_host(void *ctx)
{
    struct machine *m = ctx;
    sigset_t pending;
    sigpending(&pending);
    for (int i = 0; i < ENDINGS && !m->signal; i++)
        if (sigismember(&pending, ENDING[i]))
            m->signal = ENDING[i];
    if (m->signal)
        node_system_fail(&m->sys, STOP_INTERRUPTED, (struct instant){0},
                         m->signal == SIGINT ? "interrupted" : "stopped by SIG%s", sigabbrev_np(m->signal));
    if (m->options.max_wall_s > 0 && hostclock_s() - m->begin > m->options.max_wall_s)
        node_system_fail(&m->sys, STOP_WALL_TIME, (struct instant){0}, "wall time limit of %g s reached",
                         m->options.max_wall_s);
}

/* Reports a crash; called at the crash's place in the total order. */
static void show_crash(struct node *n)
{
    node_end_crashed(n);
    char *report = crash_report(n);
    node_system_fail(n->sys, STOP_FAILED, (struct instant){n->stats.ended_at, n->lp.address}, "%s", report);
    free(report);
}

static void *thread_begins(void)
{
    return crash_watch();
}

static void thread_ends(void *guard)
{
    crash_unwatch(guard);
}

static void run_events(struct machine *m)
{
    struct node_system *s = &m->sys;
    struct crash_guard *guard = crash_watch();
    crash_catch();
    s->keep_crash = crash_keep, s->crashed = show_crash, s->print_calls = trace_print_calls;
    s->schedule.look = poll_host, s->schedule.look_ctx = m;
    m->workers = engine_run(&s->schedule,
                            &(struct engine_threads){s->isolate ? 1 : m->options.workers, m->options.shuffle,
                                                     thread_begins, thread_ends, guard});
    crash_ignore();
    crash_unwatch(guard);
}

static bool stops_at_a_time(const struct schedule *s)
{
    return s->stop == STOP_FAILED || s->stop == STOP_VIRTUAL_TIME;
}

/* The moment at which the run ended: what comes before it in the total order has happened. */
static struct instant end_of(const struct schedule *s)
{
    return stops_at_a_time(s) ? s->stop_at : s->stop ? s->present : (struct instant){VT_NEVER, 0};
}

static void note_end(struct machine *m, struct node *n)
{
    const struct schedule *s = &m->sys.schedule;
    node_settle(n, end_of(s), stops_at_a_time(s));
    RECORD(n, end, n->stats.ended_at);
    m->end = vt_max(m->end, n->stats.ended_at);
}

void machine_run(struct machine *m)
{
    assert(m->begin == 0);
    m->begin = hostclock_s();
    sigset_t ending = ending_signals(), before;
    sigprocmask(SIG_BLOCK, &ending, &before);
    run_events(m);
    for (const struct timespec now = {0}; m->signal && sigtimedwait(&ending, NULL, &now) > 0;)
        ;
    sigprocmask(SIG_SETMASK, &before, NULL);
    for (uint32_t i = 0; i < machine_nodes(m); i++)
        note_end(m, m->sys.nodes[i]);
    if (m->sys.host)
        note_end(m, m->sys.host);
    if (m->sys.recorder)
        protocol_record_end(m->sys.schedule.protocol);
    verdict(m);
    m->wall_s = hostclock_s() - m->begin;
}
