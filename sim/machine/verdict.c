/* verdict.c - see verdict.h. */
#include "machine/verdict.h"
#include <assert.h>
#include <stdlib.h>
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "machine/waits_for.h"
#include "machine/whereabouts.h"
#include "os/orders.h"

static bool exited_badly(const struct node *n)
{
    return n->end == NODE_EXITED && n->exit_code != 0;
}

/* The first node whose program ended by exit or abort with an error; NULL if there is none. */
static struct node *bad_exit(const struct machine *m)
{
    for (uint32_t i = 0; i < m->sys.count; i++)
        if (exited_badly(m->sys.nodes[i]))
            return m->sys.nodes[i];
    return m->sys.host && exited_badly(m->sys.host) ? m->sys.host : NULL;
}

static char *explain(const struct waitfor *w)
{
    char *text;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    fputs("deadlock: every program waits, and no message is under way\n", f);
    waitfor_write_text(w, f);
    fclose(f);
    return text;
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
    const struct node *bad = bad_exit(m);
    enum stop stop = s->schedule.stop;
    bool limit = stop == STOP_VIRTUAL_TIME || stop == STOP_WALL_TIME || stop == STOP_INTERRUPTED;
    m->outcome = MACHINE_ENDED;
    if (stop == STOP_VIRTUAL_TIME && s->schedule.max_time == m->options.until) {
        stopped_at_time(m);
    } else if (s->failure) {
        m->outcome = MACHINE_FAILED;
        m->message = limit ? whereabouts(s, s->failure) : xstrdup(s->failure);
    } else if (bad) {
        m->outcome = MACHINE_FAILED;
        char *first = xasprintf("%s ended at %s with exit(%d)", bad->name,
                                virtual_time_moment(bad->stats.ended_at).text, bad->exit_code);
        m->message = s->running ? whereabouts(s, first) : xstrdup(first);
        free(first);
    } else if (s->running && s->host && s->host->lp.state == LP_ENDED) {
        m->message = whereabouts(s, "the host program has ended; what still waits on its nodes is killed");
    } else if (s->running && stop != STOP_KILLED) {
        m->outcome = MACHINE_DEADLOCK;
        m->waits = waits_for(s);
        m->waits->program = waitfor_text(m->waits, m->options.argv[0]);
        m->message = explain(m->waits);
    }
}

void verdict(struct machine *m)
{
    judge(m);
    add_unkept(m);
}
