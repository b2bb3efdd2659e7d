/* divergence.h - the first place in which a run differs from another: a receive that got another message, a
 * handler that ran elsewhere, a receive that only one of them made. */
#ifndef LAB_EXPLORE_DIVERGENCE_H
#define LAB_EXPLORE_DIVERGENCE_H
#include "lab/explore/recording.h"

enum divergence_kind {
    DIVERGENCE_NONE,
    DIVERGENCE_MESSAGE,
    DIVERGENCE_HANDLER,
    DIVERGENCE_MOMENT,
    DIVERGENCE_MISSING
};

struct divergence {
    enum divergence_kind kind;
    uint32_t node;
    uint64_t number; /* of the receive or handler */
    vtime at;        /* in the run that differs; DIVERGENCE_MISSING: in the base */
};

/* Of all differences the earliest in the run's virtual time. Only if no receive got another message, and no
 * handler ran behind another call, there is a handler that ran behind the same call at another moment: that
 * whose time differs most; and only if there is none either, a receive that one run lacks. */
struct divergence divergence_first(const struct recording *base, const struct recording *run);
/* In sentences; malloc'd. */
char *divergence_words(const struct divergence *d, const struct recording *base, const struct recording *run);
#endif
