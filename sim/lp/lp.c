/* lp.c - the making of a logical process. */
#include "lp/lp.h"

void lp_begin(struct lp *lp, struct schedule *s, uint32_t address, struct lp_cold *cold)
{
    *lp = (struct lp){.schedule = s, .address = address, .cold = cold, .blocked_since = VT_NEVER};
    cold->count = 0;
}

void lp_bind(struct lp *lp, int64_t *budget, int64_t *lookahead)
{
    lp->budget = budget, lp->lookahead = lookahead;
}

void lp_end(struct lp *lp)
{
    lp->state = LP_ENDED;
}

void lp_unbind(struct lp *lp)
{
    lp->budget = lp->lookahead = NULL;
    lp->clock.runs = false;
}
