/* compare.h - compares a point with the baseline's (baseline.h): which figures differ, whether they are
 * worse, and where the time of the point's nodes moved.
 *
 * Figures are of three kinds:
 *   costs       total_s, time_s, virtual_time_s, messages, bytes, memory_peak_bytes: more is worse
 *   speeds      speedup, speed_per_node: less is worse if the point's own time is worse; a speed is relative
 *               to the point of fewest nodes, and a change of that point's time alone is only told
 *   the others  the digest, idle times, whatever else the program prints: a difference is told and is no
 *               failure, unless a tolerance names the figure: then a difference beyond it is worse
 *
 * Results are exact: without a tolerance the last digit counts. A change for the better is no failure, except
 * where every figure must be equal (`exact`).
 */
#ifndef LAB_CHECK_COMPARE_H
#define LAB_CHECK_COMPARE_H
#include "lab/check/compare_tolerance.h"

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

/* --- a point --- */

enum compare_verdict {
    COMPARE_SAME,
    COMPARE_TOLD,    /* the differences decide nothing, or are within the tolerance */
    COMPARE_BETTER,  /* better by more than the tolerance */
    COMPARE_NEW,     /* the point is not in the baseline */
    COMPARE_WORSE,   /* this verdict and all after it are failures */
    COMPARE_MISSING, /* the point is only in the baseline */
    COMPARE_FAILED,  /* the point's run failed */
};

struct compare_figure {
    const char *name;
    const json_t *before, *after; /* NULL if absent */
    double change, change_pct;    /* NAN unless both are numbers; change_pct also if `before` is 0 */
    enum compare_verdict verdict;
};

enum compare_kind { COMPARE_FUNCTION, COMPARE_SYSTEM, COMPARE_IDLE, COMPARE_ENDED, COMPARE_KINDS };

/* A change of the seconds that all nodes of a class spent in a function, a task or a wait. */
struct compare_move {
    enum compare_kind kind;
    const char *class, *name;
    double before_s, after_s;
};

struct compare_point {
    char *study, *name, *failure;
    enum compare_verdict verdict;   /* the gravest of its figures */
    struct compare_figure *figures; /* those that differ, the gravest first, then the largest change */
    size_t figure_count;
    struct compare_move *moves; /* by kind, each the largest move first */
    size_t move_count;
    size_t order;           /* for the caller: its place among the points */
    double time_s;          /* the point's virtual time; 0 if there is none */
    bool one_profiled;      /* only one of the two has a profile: there are no moves */
    json_t *before, *after; /* what figures and moves point into; NULL if the verdict is COMPARE_SAME */
};

/* Compares; the caller frees the result by compare_free(). before is NULL for a new point, after for a
 * missing or failed one; failure tells why the run failed, or is NULL. */
struct compare_point *compare_point(const char *study, const char *name, json_t *before, json_t *after,
                                    const char *failure, const struct compare_rules *rules);
void compare_free(struct compare_point *p);

static inline bool compare_is_failure(enum compare_verdict v)
{
    return v >= COMPARE_WORSE;
}
#endif
