/* machine_run.c - runs a machine (machine.h): starts its threads, and settles the nodes' accounts at the
 * end. */
#include <assert.h>
#include <stdlib.h>
#include "guest/backtrace.h"

#include "guest/elffile.h"
#include "guest/image.h"
#include "guest/libc/libc.h"
#include "guest/refusal.h"
#include "kernel/hostclock.h"
#include "lp/engine.h"
#include "machine/crash.h"
#include "machine/machine.h"
#include "machine/refused_file.h"
#include "machine/outside.h"
#include "machine/overdue.h"
#include "machine/verdict.h"
#include "net/protocol_record.h"
#include "os/end.h"
#include "os/first_failure.h"
#include "os/observer.h"
#include "replay/numbering.h"
#include "replay/schedule_record.h"
#include "races/race_check.h"
#include "timing/draw_read.h"

/* Reports a crash; called at the crash's place in the total order. A program that was ended since the run is
 * overdue has no fault: the run ends for the reason for which it was to end. */
static void show_crash(struct node *n)
{
    if (!crash_is_fault(n)) {
        n->sys->schedule.look(n->sys->schedule.look_ctx);
        assert(n->sys->schedule.stop);
        return;
    }
    node_end_crashed(n);
    char *report = crash_report(n);
    node_system_fail(n->sys, STOP_FAILED, (struct instant){n->stats.ended_at, n->lp.address}, "%s", report);
    free(report);
}

/* Beside the calls, an allocation that was refused if the failure came from it. */
static void print_calls(FILE *f, const struct node *n, uintptr_t frame)
{
    if (refusal_was_last(n))
        refusal_print(f, n);
    backtrace_print_calls(f, n, frame);
}

static void run_events(struct machine *m)
{
    struct node_system *s = &m->sys;
    struct crash_guard *guard = crash_watch();
    crash_catch();
    overdue_begin(m);
    s->keep_crash = crash_keep, s->crashed = show_crash, s->print_calls = print_calls;
    s->calls_from = backtrace_walk;
    s->refused = refused_file, s->exited = verdict_exited;
    s->schedule.look = outside_look, s->schedule.look_ctx = m;
    debug_stop_begin(s, &m->stop, &m->options.stop);
    m->workers =
        engine_run(&s->schedule, &(struct engine_threads){s->isolate || s->debugger ? 1 : m->options.workers,
                                                          m->options.shuffle, crash_thread_begins,
                                                          crash_thread_ends, overdue_hurry, guard});
    overdue_end();
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
    ANNOUNCE(n, ends, n->stats.ended_at);
    m->end = vt_max(m->end, n->stats.ended_at);
}

static void begin_schedule(const struct machine *m)
{
    if (!m->sys.numbering || !m->sys.numbering->out)
        return;
    char *drawn = m->options.draw ? draw_text(m->options.draw) : NULL;
    schedule_record_begin(&m->sys, drawn, node_image_path(m->images[0]), machine_program_sum(m));
    free(drawn);
}

/* What receives have and programs never asked for; what nobody received. */
static void end_schedule(struct machine *m)
{
    struct node_system *s = &m->sys;
    if (!s->numbering)
        return;
    for (uint32_t i = 0; i < machine_nodes(m); i++)
        numbering_over(s->nodes[i]);
    if (s->host)
        numbering_over(s->host);
    if (s->numbering->out)
        schedule_record_end(s);
}

/* Has the program printed exactly what it was to print by the end of the run? A program that crashed has, and
 * in a deadlock each that was not killed has. At a limit, programs may have computed further than that, and
 * killed ones further than to their end; at a signal, too, but no two such runs are alike anyway. */
static bool has_output(const struct machine *m, const struct node *n)
{
    return n->guest.libc &&
           (n->end.how == NODE_CRASHED || (m->waits && n->end.how != NODE_KILLED) || m->signal);
}

static void rescue_output(struct machine *m)
{
    for (uint32_t i = 0; i < machine_nodes(m); i++)
        if (has_output(m, m->sys.nodes[i]))
            node_libc_rescue(m->sys.nodes[i]);
    if (m->sys.host && has_output(m, m->sys.host))
        node_libc_rescue(m->sys.host);
}

void machine_run(struct machine *m)
{
    assert(m->begin == 0);
    outside_begin(m);
    begin_schedule(m);
    run_events(m);
    outside_end(m);
    for (uint32_t i = 0; i < machine_nodes(m); i++)
        note_end(m, m->sys.nodes[i]);
    if (m->sys.host)
        note_end(m, m->sys.host);
    races_over(m->sys.races);
    if (m->sys.recorder)
        protocol_record_end(m->sys.schedule.protocol);
    end_schedule(m);
    verdict(m);
    rescue_output(m);
    m->wall_s = hostclock_s() - m->begin;
}
