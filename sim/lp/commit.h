/* commit.h - the choice of the machine's next event. */
#ifndef LP_COMMIT_H
#define LP_COMMIT_H
#include "lp/schedule.h"

/* Does a node's poll time come before (time, address)? */
static inline bool commit_poll_is_before(const struct schedule *s, vtime time, uint32_t address)
{
    vtime poll = mintree_least(&s->polls);
    return poll < time || (poll == time && poll != VT_NEVER && mintree_address(&s->polls) < address);
}
#endif
