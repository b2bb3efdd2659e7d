/* share.c - see share.h. */
#include "os/share.h"
#include "lp/clock.h"
#include "node/system.h"

void share_give(struct node *n, vtime h)
{
    const uint64_t share = n->sys->cfg->program_milli;
    n->handlers.share_until =
        (n->handlers.share_until > n->lp.clock.units ? n->handlers.share_until : n->lp.clock.units) +
        clock_units_in(&n->lp, h / (1000 - share) * share);
}

void share_use(struct node *n, vtime t)
{
    uint64_t left = n->handlers.share_until > n->lp.clock.units ? n->handlers.share_until - n->lp.clock.units
                                                                : 0,
             used;
    if (!left || n->in_handler)
        return;
    used = clock_units_in(&n->lp, t);
    n->handlers.share_until -= used < left ? used : left;
}

void share_end(struct node *n)
{
    n->handlers.share_until = 0;
}
