/* compare.h - a point as it is against the point as a baseline has it (baseline.h): which figures differ, whether that is
 * worse, and where the time of its nodes moved.
 *
 * Figures of three kinds:
 *   costs       total_s, time_s, virtual_time_s, messages, bytes, memory_peak_bytes: more is worse
 *   speeds      speedup, speed_per_node: less is worse, if the point's own time is; where only the time of the fewest
 *               nodes has changed, which they are relative to, they are told like the others
 *   the others  the digest, idle times, whatever else the program prints: told, but no reason to fail; unless a tolerance
 *               names it: then any difference beyond is worse
 * Results are exact: without a tolerance the last digit counts. A change for the better is never a failure, except
 * where everything must be the same (`exact`).
 */
#ifndef LAB_CHECK_COMPARE_H
#define LAB_CHECK_COMPARE_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

/* --- how much may differ (compare_tolerance.c) --- */

struct compare_tolerance {
    char *figure;   /* NULL: all costs and speeds that no other names */
    double allowed; /* of the baseline's value if relative, else in the figure's own unit */
    bool relative;
    bool used; /* a point has this figure */
};

struct compare_rules {
    struct compare_tolerance *tolerances;
    size_t count;
    bool exact; /* any difference is worse, in any figure */
};

/* Adds "0.5%", "total_s=1%", "messages=10", or several of them with commas between. False with *why malloc'd. */
bool compare_rules_add(struct compare_rules *rules, const char *text, char **why);
void compare_rules_clear(struct compare_rules *rules);
/* Notes which tolerances a point (baseline.h) has figures for; and then, the first figure that is named and that no point
 * has; NULL: none. */
void compare_rules_see(struct compare_rules *rules, const json_t *point);
const char *compare_rules_unused(const struct compare_rules *rules);

/* --- a point --- */

enum compare_verdict {
    COMPARE_SAME,
    COMPARE_TOLD,    /* figures differ that decide nothing, or within the tolerance */
    COMPARE_BETTER,  /* beyond the tolerance */
    COMPARE_NEW,     /* the baseline has not got it */
    COMPARE_WORSE,   /* this and what follows is a failure */
    COMPARE_MISSING, /* only the baseline has it */
    COMPARE_FAILED,  /* its run failed */
};

struct compare_figure {
    const char *name;
    const json_t *before, *after; /* NULL: it is not there */
    double change, change_pct;    /* NAN unless both are numbers; the latter also where the first is 0 */
    enum compare_verdict verdict;
};

enum compare_kind { COMPARE_FUNCTION, COMPARE_SYSTEM, COMPARE_IDLE, COMPARE_ENDED, COMPARE_KINDS };

/* Seconds of all nodes of a class together. */
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
    double time_s;          /* its virtual time; 0: none */
    bool one_profiled;      /* only one of the two: so no moves */
    json_t *before, *after; /* what the others point into; NULL if they are the same */
};

/* before or after is NULL where there is none; failure: why `after` is missing, or NULL. */
struct compare_point *compare_point(const char *study, const char *name, json_t *before, json_t *after,
                                    const char *failure, const struct compare_rules *rules);
void compare_free(struct compare_point *p);

static inline bool compare_is_failure(enum compare_verdict v)
{
    return v >= COMPARE_WORSE;
}
#endif
