/* explore.h - a program under other timings that its machine could have had (doc/explore.md).
 *
 *     explore_open()    checks program and machine, opens DIR, its journal and the session's locks
 *     explore_run()     makes the runs (search.h, batch.h); finds for each outcome that differs the fewest
 *                       delays that show it, and where it first differs from the usual timing
 *     explore_print(), explore_json()    the report (explore_report.h, explore_json.h)
 *
 * DIR/journal has the results, DIR/runs the recordings of runs that were not equal to others, and
 * DIR/NAME.schedule the fewest delays of each outcome that differs. After any interruption the same command
 * goes on, and makes no run twice. The processes of a session share the runs, and all have the results. */
#ifndef LAB_EXPLORE_EXPLORE_H
#define LAB_EXPLORE_EXPLORE_H
#include "lab/explore/divergence.h"
#include "lab/explore/least.h"
#include "lab/explore/search.h"

struct explore_options {
    struct subject_options subject;
    struct verdict_rules rules;
    const char *dir;
    const char *session; /* its name (lab/jobs/session.h); "": a single process */
    struct draw draw;    /* the bounds, and the most of PCT's depth */
    size_t runs;         /* at most */
    double seconds;      /* of host time, after which no run begins; 0: no limit */
    double limit_s;      /* of host time for one run */
    unsigned at_once;
    size_t tests;     /* at most, to find the fewest delays of an outcome */
    size_t explained; /* of so many outcomes that differ the fewest delays are found */
    FILE *notes;      /* for progress and warnings */
};

/* What was found of an outcome that differs. */
struct explained {
    char *name; /* "deadlock-1": of DIR/NAME.schedule; NULL: it was not looked at */
    struct least least;
    char *first; /* where it first differs, in sentences; NULL: not known */
};

struct explore {
    struct explore_options options;
    struct subject *subject;
    struct scratch scratch;
    char *own_folders; /* where in it the runs' folders are */
    struct batch_place place;
    struct search search;
    struct explained *explained; /* by search.outcomes; the base's is empty */
    size_t made, before;         /* of the search's runs: made here, in the journal before */
    double wall_s;
    bool out_of_time, hinted; /* hinted: EXPLORE_TIMES_HINT has been said while the runs went on */
};

struct explore *explore_open(const struct explore_options *o, char **error); /* NULL with *error */
/* False with *error; or, without, if a signal has stopped it (place.signal). */
bool explore_run(struct explore *x, char **error);
void explore_close(struct explore *x);

/* What to do where runs of one order have different outputs. */
extern const char EXPLORE_TIMES_HINT[];

/* After explore_run(): did the program end well with the usual timing? */
bool explore_usual_ended(const struct explore *x);

/* The command that repeats a run of the outcome, in the current folder; malloc'd. */
char *explore_command(const struct explore *x, size_t outcome, const char *timing, const char *replay);

/* Does this process write the report? One of a session does. */
bool explore_reports(struct explore *x);
#endif
