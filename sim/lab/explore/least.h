/* least.h - the fewest delays with which a run still has its outcome. */
#ifndef LAB_EXPLORE_LEAST_H
#define LAB_EXPLORE_LEAST_H
#include "lab/explore/batch.h"
#include "lab/explore/flips.h"
#include "lab/explore/recording.h"

struct least {
    struct delays delays; /* of the schedule; the caller frees them */
    bool repeats;      /* the recorded delays alone repeat the outcome. False: delays are the recorded ones */
    bool is_least;     /* without any one of them the outcome is another; false: the tests did not suffice */
    size_t tests;      /* runs that were needed */
    struct digest key; /* of the run with these delays, which has a recording; if repeats */
};

/* Finds the fewest of a recording's delays with which runs still are of that group (run_verdict.h), by at
 * most `tests` tests (delta.h), and then as many again with these delays at their bounds: of longer delays
 * fewer may do. False with *error, or by a signal. */
bool least_find(struct batch_place *place, const struct recording *r, const struct delay_bounds *bounds,
                const char *group, size_t tests, struct least *l, char **error);
#endif
