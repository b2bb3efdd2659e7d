/* outside.c - see outside.h. */
#include "machine/outside.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "files/virtual_time.h"
#include "guest/libc/progress_line.h"
#include "kernel/hostclock.h"
#include "kernel/xalloc.h"
#include "lp/engine.h"
#include "machine/overdue.h"
#include "machine/whereabouts.h"
#include "os/first_failure.h"

/* Signals that end a run. SIGUSR1 asks where the nodes are. */
static const int ENDING[] = {SIGINT, SIGTERM, SIGHUP};
enum { ENDINGS = sizeof ENDING / sizeof *ENDING };

/* Seconds of host time before the first progress line, and from one to the next. */
static const double PROGRESS_AFTER = 1, PROGRESS_EVERY = 0.25;

/* Seconds after which the programs' output reaches its file, so that users see how far a long run has
 * come. */
static const double OUTPUT_EVERY = 0.1;

/* Those of the signals that are not ignored, as they are under nohup. SIGINT is a debugger's, if there is
 * one: it stops the run. */
static sigset_t signals_of(const struct machine *m)
{
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGUSR1);
    for (int i = 0; i < ENDINGS; i++) {
        struct sigaction now;
        if (m->sys.debugger && ENDING[i] == SIGINT)
            continue;
        if (sigaction(ENDING[i], NULL, &now) == 0 && now.sa_handler != SIG_IGN)
            sigaddset(&set, ENDING[i]);
    }
    return set;
}

void outside_begin(struct machine *m)
{
    m->begin = hostclock_s();
    m->progress = (struct progress_line){.f = m->options.err};
    m->progress_at = m->begin + PROGRESS_AFTER;
    if (m->options.progress && !m->sys.debugger)
        m->sys.progress = &m->progress;
    sigset_t signals = signals_of(m);
    sigprocmask(SIG_BLOCK, &signals, &m->signals_before);
}

static void take_signal(int signal)
{
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, signal);
    for (const struct timespec now = {0}; sigtimedwait(&one, NULL, &now) > 0;)
        ;
}

/* The machine does nothing more before this time. */
static vtime come_to(const struct schedule *s)
{
    const struct fiber *f = fiber_current(); /* looks from a poll */
    vtime t = vt_min(evq_next(s->q), mintree_least(&s->polls));
    t = vt_min(t, engine_bound(s));
    if (f)
        t = vt_min(t, ((const struct node *)fiber_arg(f))->lp.clock.now);
    return t == VT_NEVER ? s->present.time : vt_max(t, s->present.time);
}

/* Virtual time is far on: from now on the engine asks before each event whether time is at its end. */
static void see_end_of_time(struct schedule *s)
{
    if (s->max_time != VT_NEVER || come_to(s) < VT_NEVER / 2)
        return;
    engine_hold(s);
    s->max_time = VT_LAST;
    engine_release(s);
}

static void tell_where(struct machine *m)
{
    struct node_system *s = &m->sys;
    engine_hold(&s->schedule);
    char *what = xasprintf("at %s of virtual time, after %" PRIu64 " messages:",
                           virtual_time_moment(come_to(&s->schedule)).text, s->messages);
    char *text = whereabouts_grouped(s, what);
    if (s->progress)
        progress_line_clear(s->progress);
    fprintf(m->options.err, "touchstone run: %s\n", text);
    fflush(m->options.err);
    free(text);
    free(what);
    engine_release(&s->schedule);
}

static void show_output(struct machine *m, double now)
{
    if (now < m->output_at)
        return;
    m->output_at = now + OUTPUT_EVERY;
    fflush(m->sys.out[0]);
}

static void show_progress(struct machine *m, double now)
{
    const struct schedule *s = &m->sys.schedule;
    double at = vt_seconds(come_to(s)), limit = m->options.max_virtual_s;
    char text[120], share[60] = "";
    if (now < m->progress_at)
        return;
    m->progress_at = now + PROGRESS_EVERY;
    if (limit > 0)
        snprintf(share, sizeof share, ", %.0f %% of %s", 100 * at / limit, limit_text(limit).text);
    snprintf(text, sizeof text, "%s on %u nodes, %" PRIu64 " messages%s", duration_text(at).text,
             machine_nodes(m), m->sys.messages, share);
    progress_line_show(m->sys.progress, text);
}

/* outside_take_ending(), of the signals that wait. */
static int take_ending(struct machine *m, const sigset_t *pending)
{
    int i = 0;
    while (i < ENDINGS && !sigismember(pending, ENDING[i]))
        i++;
    if (i == ENDINGS)
        return 0;
    take_signal(ENDING[i]);
    if (!m->signal) {
        m->signal = ENDING[i];
        overdue_from_now();
    }
    return ENDING[i];
}

int outside_take_ending(struct machine *m)
{
    sigset_t pending;
    sigpending(&pending);
    return take_ending(m, &pending);
}

static void poll_signals(struct machine *m)
{
    sigset_t pending;
    sigpending(&pending);
    if (!m->signal)
        take_ending(m, &pending);
    if (m->signal)
        node_system_fail(&m->sys, STOP_INTERRUPTED, (struct instant){0},
                         m->signal == SIGINT ? "interrupted" : "stopped by SIG%s", sigabbrev_np(m->signal));
    else if (sigismember(&pending, SIGUSR1)) {
        take_signal(SIGUSR1);
        tell_where(m);
    }
}

void outside_look(void *ctx)
{
    struct machine *m = ctx;
    double now = hostclock_s();
    poll_signals(m);
    see_end_of_time(&m->sys.schedule);
    show_output(m, now);
    if (m->sys.progress)
        show_progress(m, now);
    if (m->options.max_wall_s > 0 && !m->sys.debugger && now - m->begin > m->options.max_wall_s)
        node_system_fail(&m->sys, STOP_WALL_TIME, (struct instant){0}, "wall time limit of %s reached",
                         limit_text(m->options.max_wall_s).text);
}

void outside_end(struct machine *m)
{
    if (m->sys.progress)
        progress_line_clear(m->sys.progress);
    take_signal(SIGUSR1);
    for (int i = 0; m->signal && i < ENDINGS; i++)
        take_signal(ENDING[i]);
    sigprocmask(SIG_SETMASK, &m->signals_before, NULL);
}
