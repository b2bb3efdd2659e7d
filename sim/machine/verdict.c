/* verdict.c - see verdict.h. */
#include "machine/verdict.h"
#include <assert.h>
#include <stdlib.h>
#include "files/virtual_time.h"
#include "guest/backtrace.h"
#include "guest/refusal.h"
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "machine/waits_for.h"
#include "machine/whereabouts.h"
#include "nx_api/contract/program_image.h"
#include "os/end.h"
#include "replay/orders.h"

static char *exit_text(const struct node *n)
{
    struct backtrace_lines *lines = backtrace_lines_new();
    const char *line = backtrace_line_of(lines, n, n->cold->exit_calls, NODE_EXIT_CALLS);
    char *text = xasprintf("%s ended at %s with exit(%d)%s%s%s", n->cold->name,
                           virtual_time_moment(n->stats.ended_at).text, n->end.exit_code, line ? " (" : "",
                           line ? line : "", line ? ")" : "");
    backtrace_lines_free(lines);
    return text;
}

/* For reports, which name the line: main's, if it has returned. */
static void note_calls(struct node *n)
{
    uintptr_t *calls = n->cold->exit_calls;
    int depth = backtrace_walk(n, (uintptr_t)crossing_frame(), calls, NODE_EXIT_CALLS);
    if (!depth)
        calls[depth++] = (uintptr_t)n->guest.image->main + 1;
    if (depth < NODE_EXIT_CALLS)
        calls[depth] = 0;
}

/* With what it was refused before, if that may be why. */
static char *exit_report(const struct node *n)
{
    char *text, *end = exit_text(n);
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    fprintf(f, "%s", end);
    if (refusal_was_last(n))
        refusal_print(f, n);
    fclose(f);
    free(end);
    return text;
}

/* The first is told at once: what the others wait or poll for may not come any more. (A host program is told
 * by waitall.) */
void verdict_exited(struct node *n)
{
    struct node_system *s = n->sys;
    note_calls(n);
    if (s->host || s->exit_told || !s->running)
        return;
    s->exit_told = true;
    char *text = exit_report(n);
    if (s->progress)
        progress_line_clear(s->progress);
    fflush(s->out[0]);
    fprintf(s->out[1], "%stouchstone run: %s\n", s->mid_line ? "\n" : "", text);
    s->mid_line = false;
    fflush(s->out[1]);
    free(text);
}

/* Why all that has not ended waits. */
static char *explain(struct machine *m, const char *head, const char *more)
{
    char *text;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    m->waits = waits_for(&m->sys);
    m->waits->program = waitfor_text(m->waits, m->options.programs[0].argv[0]);
    fprintf(f, "%s%s\n", head, more);
    waitfor_write_text(m->waits, f);
    fclose(f);
    return text;
}

/* A program ended by exit with an error. Do others still wait, why? */
static void failed_by_exit(struct machine *m, const struct node *bad)
{
    struct node_system *s = &m->sys;
    char *first = exit_text(bad);
    bool host_ended = s->host && s->host->lp.state == LP_ENDED;
    m->outcome = MACHINE_FAILED;
    if (!s->running)
        m->message = exit_report(bad), m->said = s->exit_told;
    else if (s->schedule.stop || host_ended)
        m->message = whereabouts(s, first);
    else
        m->message = explain(m, first, "; the others wait, and no message is under way");
    free(first);
}

/* The run was to go no further than this. */
static void stopped_at_time(struct machine *m)
{
    char *what = xasprintf("stopped at %s of virtual time:", virtual_time_moment(m->options.until).text);
    m->outcome = MACHINE_STOPPED;
    m->message = whereabouts(&m->sys, what);
    free(what);
}

/* Adds the lines of the schedule that the run has not kept; a run that has ended all the same has failed.
 * (What failed for another reason has told that reason.) */
static void add_unkept(struct machine *m)
{
    bool asks = m->outcome == MACHINE_ENDED || m->outcome == MACHINE_DEADLOCK;
    char *unkept = asks ? orders_unkept(&m->sys) : NULL, *before = m->message;
    if (!unkept)
        return;
    if (m->outcome == MACHINE_ENDED)
        m->outcome = MACHINE_FAILED;
    m->message = xasprintf("%s%s", before ? before : "the run has not kept its schedule:", unkept);
    free(before);
    free(unkept);
}

static void judge(struct machine *m)
{
    assert(!m->message);
    struct node_system *s = &m->sys;
    const struct node *bad = node_bad_exit(s);
    enum stop stop = s->schedule.stop;
    bool limit = stop == STOP_VIRTUAL_TIME || stop == STOP_WALL_TIME || stop == STOP_INTERRUPTED;
    m->outcome = MACHINE_ENDED;
    if (stop == STOP_VIRTUAL_TIME && m->options.until && s->schedule.max_time == m->options.until) {
        stopped_at_time(m);
    } else if (s->failure) {
        m->outcome = MACHINE_FAILED;
        m->message = limit ? whereabouts(s, s->failure) : xstrdup(s->failure);
    } else if (bad) {
        failed_by_exit(m, bad);
    } else if (s->running && s->host && s->host->lp.state == LP_ENDED) {
        m->message = whereabouts(s, "the host program has ended; what still waits on its nodes is killed");
    } else if (s->running && stop != STOP_KILLED) {
        m->outcome = MACHINE_DEADLOCK;
        m->message = explain(m, "deadlock: every program waits", ", and no message is under way");
    }
}

void verdict(struct machine *m)
{
    judge(m);
    add_unkept(m);
}
