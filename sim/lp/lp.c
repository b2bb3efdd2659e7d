/* lp.c - the making of a logical process. */
#include "lp/lp.h"
#include <stdlib.h>

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
    lp->state = LP_ENDED;
}

void lp_unbind(struct lp *lp)
{
    lp->budget = lp->lookahead = NULL;
    lp->clock.runs = false;
    free(lp->places);
    lp->places = NULL;
}
