/* verdict.c - see verdict.h. */
#include "machine/verdict.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "machine/whereabouts.h"

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

void verdict(struct machine *m)
{
    assert(!m->message);
    struct node_system *s = &m->sys;
    const struct node *bad = bad_exit(m);
    enum stop stop = s->schedule.stop;
    bool limit = stop == STOP_VIRTUAL_TIME || stop == STOP_WALL_TIME || stop == STOP_INTERRUPTED;
    m->outcome = MACHINE_ENDED;
    if (s->failure) {
        m->outcome = MACHINE_FAILED;
        m->message = limit ? whereabouts(s, s->failure) : xstrdup(s->failure);
    } else if (bad) {
        m->outcome = MACHINE_FAILED;
        char *first = xasprintf("%s ended at %.9f s with exit(%d)", bad->name,
                                vt_seconds(bad->stats.ended_at), bad->exit_code);
        m->message = s->running ? whereabouts(s, first) : xstrdup(first);
        free(first);
    } else if (s->running && s->host && s->host->lp.state == LP_ENDED) {
        m->message = whereabouts(s, "the host program has ended; what still waits on its nodes is killed");
    } else if (s->running && stop != STOP_KILLED) {
        m->outcome = MACHINE_DEADLOCK;
        m->message = whereabouts(s, "deadlock: every program waits, and no message is under way");
    }
}
