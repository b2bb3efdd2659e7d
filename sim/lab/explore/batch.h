/* batch.h - runs of an exploration, many at a time, each at most once: what the journal has is not run again,
 * and the processes of a session share the rest by locks.
 *
 * All processes of a session call batch_do() with the same runs in the same order, and all have all results
 * when it returns: so each takes the same decisions. */
#ifndef LAB_EXPLORE_BATCH_H
#define LAB_EXPLORE_BATCH_H
#include "files/scratch.h"
#include "lab/explore/subject.h"
#include "lab/explore/run_verdict.h"
#include "lab/jobs/journal.h"
#include "lab/jobs/point_locks.h"
#include "lab/jobs/progress.h"

/* One run: what to do, and after batch_do() its result. */
struct planned_run {
    char *name;     /* for people: "seed 17 (random)" */
    char *timing;   /* as in struct run_timing */
    char *schedule; /* both NULL: the usual timing */
    struct digest key;
    /* As verdict_of() has it, with name, wall_time_s, and of the recording, if there is one: order
     * (order_of_run), delays (how many it has), events (messages and handlers). NULL: there was no time left,
     * or the run had no end: `failure` */
    json_t *record;
    char *failure; /* why; NULL */
};

/* name, timing and schedule are taken over. */
struct planned_run planned_run(const struct subject *s, char *name, char *timing, char *schedule);
void planned_run_free(struct planned_run *r);

struct batch_place {
    const struct subject *subject;
    const struct verdict_rules *rules;
    const char *dir; /* of journal and recordings */
    const char *scratch;
    struct journal *journal;
    struct point_locks *locks;
    unsigned at_once;
    double deadline_s; /* of the host's clock, after which no run begins; 0: none */
    double limit_s;    /* of host time, for a run */
    FILE *notes;       /* for progress; not NULL */
    size_t all;        /* so many runs are to be made in all, for progress */

    /* what has been done, for progress and report */
    size_t done, run, before; /* with a result; of these run here; in the journal when asked for */
    double begun_s;
    int signal; /* that ended the runs; 0: none */
};

/* False with *error malloc'd, or if a signal came (place->signal). */
bool batch_do(struct batch_place *place, struct planned_run *runs, size_t count, char **error);

/* DIR/runs/KEY.schedule, the recording of a run; malloc'd. */
char *batch_recording(const struct batch_place *place, struct digest key);
#endif
