/* end.c - see end.h. */
#include "os/end.h"
#include <assert.h>
#include "lp/engine.h"
#include "os/charge.h"
#include "os/gate.h"
#include "os/match.h"
#include "os/observer.h"

static void has_ended(struct node *n, enum node_end how, int code, vtime at)
{
    n->end.how = how;
    n->end.exit_code = code;
    lp_end(&n->lp);
    n->stats.ended_at = at;
    ANNOUNCE(n, ends, at);
    n->sys->running--;
    if (n->sys->cube)
        match_abandon(n); /* another program may come */
    if (!n->sys->await_ends)
        return;
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (n->sys->nodes[i]->end.awaits)
            lp_wake(&n->sys->nodes[i]->lp, at);
    if (n->sys->host && n->sys->host->end.awaits)
        lp_wake(&n->sys->host->lp, at);
}

_Noreturn void node_end_here(struct node *n, enum node_end how, int code)
{
    if (!n->sys->schedule.stop)
        node_order(n);
    has_ended(n, how, code, node_now(n));
    if (node_exited_badly(n) && n->sys->exited)
        n->sys->exited(n);
    assert(charge_adds_up(n));
    fiber_finish(&n->lp.fiber);
}

const struct node *node_bad_exit(const struct node_system *s)
{
    const struct node *first = s->host && node_exited_badly(s->host) ? s->host : NULL;
    for (uint32_t i = s->count; i-- > 0;)
        if (node_exited_badly(s->nodes[i]) &&
            (!first || s->nodes[i]->stats.ended_at <= first->stats.ended_at))
            first = s->nodes[i];
    return first;
}

void node_stop(struct node *n, struct instant at)
{
    n->end.cut_short = lp_roll_back(&n->lp, at);
    n->stats.away = at.time - charge_sum(n);
}

void node_end_other(struct node *n, struct node *victim)
{
    vtime now = node_now(n);
    if (victim->lp.state == LP_ENDED)
        return;
    node_stop(victim, (struct instant){now, n->lp.address});
    has_ended(victim, NODE_KILLED, 0, now);
}

void node_awaits_end(struct node *n, bool awaits)
{
    n->sys->await_ends += (uint32_t)awaits - n->end.awaits;
    n->end.awaits = awaits;
}

void node_notice_end(struct node *n)
{
    n->end.noticed = true;
}

void node_end_crashed(struct node *n)
{
    lp_end(&n->lp);
    n->end.how = NODE_CRASHED;
    n->end.cut_short = !n->call.name;
    n->stats.ended_at = node_now(n);
}

void node_settle(struct node *n, struct instant end, bool at_a_time)
{
    engine_settle(&n->lp, end);
    if (lp_computes(&n->lp) && at_a_time) {
        node_stop(n, end);
        n->stats.ended_at = end.time;
        if (n->call.name && !instant_before(n->call.since, n->lp.address, end))
            n->call.name = NULL; /* the program has not come to the call */
    } else if (n->lp.state != LP_ENDED) {
        n->stats.ended_at = node_now(n);
    }
}
