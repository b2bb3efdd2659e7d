/* lookahead.c - see lookahead.h. */
#include "lp/lookahead.h"
#include "lp/clock.h"
#include "lp/upcalls.h"

static vtime horizon(const struct lp *lp)
{
    const struct schedule *s = lp->schedule;
    vtime next = vt_min(evq_next(s->q), mintree_least(&s->polls));
    if (s->workers)
        next = vt_min(next, workers_bound(s->workers));
    return protocol_horizon(s->protocol, lp->address, next);
}

bool lp_is_alone(const struct lp *lp, vtime t)
{
    return horizon(lp) > t;
}

/* (Inlined, it would take registers that lp_deadline saves for each call of every program.) */
static __attribute__((noinline)) vtime interruptible_until(const struct lp *lp, vtime end)
{
    return lp->until ? lp->until : vt_min(end, vt_min(up_next_interrupt(lp), horizon(lp)));
}

vtime lp_deadline(struct lp *lp)
{
    vtime end = schedule_end_of_time(lp->schedule);
    lp->interruptible = up_is_interruptible(lp);
    return lp->interruptible ? interruptible_until(lp, end) : end;
}

/* (System time that was stolen from a program in its own call puts it off at the poll.) */
vtime lp_lookahead(const struct lp *lp)
{
    if (up_in_handler(lp) || lp->clock.stolen)
        return 0;
    return vt_min(clock_lookahead(lp), vt_min(schedule_end_of_time(lp->schedule), up_next_interrupt(lp)));
}
