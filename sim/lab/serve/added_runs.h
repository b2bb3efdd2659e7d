/* added_runs.h - runs of single points that pages ask for: checked, started as children
 * (lab/jobs/process_pool.h), stored in the study's folder (live_study.h). A request is a JSON object:
 *
 *     values    AXIS: value for each axis of the study that is not derived
 *     set       [KEY=NUMBER ...]: more numbers of the machine; may be missing
 *
 * What is run is the study's own program, with the arguments and settings that the study file gives for
 * the values. A value is one of the study file's, or a number; of a setting, too, only the number is the
 * page's. */
#ifndef LAB_SERVE_ADDED_RUNS_H
#define LAB_SERVE_ADDED_RUNS_H
#include "lab/jobs/process_pool.h"
#include "lab/serve/live_study.h"

enum { ADDED_MOST_WAITING = 64, ADDED_MOST_SETTINGS = 16, ADDED_MOST_SETTING = 128 };

struct added_places {
    const char *runner, *machines; /* the touchstone that runs points; the folder of machine files */
    FILE *notes;                   /* for what a page cannot be told */
};

/* NULL with *error malloc'd. */
struct added_runs *added_runs_new(const struct added_places *places, char **error);
void added_runs_free(struct added_runs *r);

enum added_answer {
    ADDED_TAKEN,   /* *id tells the run */
    ADDED_WRONG,   /* *error, malloc'd: what is wrong with the request, and what is allowed */
    ADDED_KNOWN,   /* *error: there is a result, or a run */
    ADDED_TOO_MANY /* *error: enough runs wait */
};
enum added_answer added_runs_ask(struct added_runs *r, struct live_study *study, const json_t *request,
                                 unsigned *id, char **error);
/* Has the run stopped: a waiting one never begins, a running one is killed within a second. False if there is
 * no such run. */
bool added_runs_stop(struct added_runs *r, unsigned id);

/* For the process pool. */
enum pool_next added_runs_next(struct added_runs *r, struct pool_job **job);
void added_runs_ended(struct added_runs *r, struct pool_job *job);

/* The latest runs: [{ id, study, name, state, error }]; study: as people know it; state: waiting, running,
 * done, failed, stopped. The caller owns it. */
json_t *added_runs_json(const struct added_runs *r);
#endif
