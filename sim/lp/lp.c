/* lp.c - the making of a logical process, and its states. */
#include "lp/lp.h"
#include <stdlib.h>

#define TO(state) (1u << LP_##state)

bool lp_may_become(enum lp_state now, enum lp_state next)
{
    static const unsigned MAY[] = {
        [LP_COMPUTING] = TO(PAUSED) | TO(OFFLOADED) | TO(BLOCKS_LAZILY) | TO(BLOCKED) | TO(ENDED),
        [LP_PAUSED] = TO(COMPUTING),
        [LP_OFFLOADED] = TO(COMPUTING),
        [LP_BLOCKS_LAZILY] = TO(COMPUTING) | TO(BLOCKED),
        [LP_BLOCKED] = TO(COMPUTING) | TO(ENDED),
        [LP_ENDED] = 0,
    };
    return MAY[now] >> next & 1;
}

void lp_begin(struct lp *lp, struct schedule *s, uint32_t address)
{
    *lp = (struct lp){.schedule = s, .address = address, .blocked_since = VT_NEVER};
}

void lp_bind(struct lp *lp, int64_t *budget, int64_t *lookahead)
{
    lp->budget = budget, lp->lookahead = lookahead;
}

void lp_end(struct lp *lp)
{
    lp_become(lp, LP_ENDED);
}

void lp_unbind(struct lp *lp)
{
    lp->budget = lp->lookahead = NULL;
    lp->clock.runs = false;
    free(lp->places);
    lp->places = NULL;
}
