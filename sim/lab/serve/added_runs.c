/* added_runs.c - see added_runs.h. */
#include "lab/serve/added_runs.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "files/folder_make.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/jobs/outcome.h"
#include "files/words.h"
#include "lab/serve/point_request.h"

enum { MOST_REMEMBERED = 32 };
enum run_state { RUN_WAITING, RUN_RUNNING, RUN_DONE, RUN_FAILED, RUN_STOPPED };
static const char *const STATES[] = {"waiting", "running", "done", "failed", "stopped"};

struct added_run {
    unsigned id;
    enum run_state state;
    struct live_study *study;
    struct point_request request;
    struct pool_job job;
    char *error;
    struct added_run *later;
};

struct added_runs {
    struct added_places places;
    struct scratch scratch;
    char **env;
    struct added_run *first; /* in the order of their numbers */
    unsigned count, latest;
};

struct added_runs *added_runs_new(const struct added_places *places, char **error)
{
    struct added_runs *r = xcalloc(1, sizeof *r);
    r->places = *places;
    r->scratch = folder_scratch("touchstone-serve", error);
    if (!r->scratch.path)
        return free(r), NULL;
    r->env = point_run_environment(r->scratch.path);
    return r;
}

static void forget(struct added_runs *r, struct added_run **at)
{
    struct added_run *run = *at;
    *at = run->later;
    point_request_clear(&run->request);
    pool_clear(&run->job, 1);
    free(run->error);
    free(run);
    r->count--;
}

void added_runs_free(struct added_runs *r)
{
    while (r->first)
        forget(r, &r->first);
    words_free(r->env);
    scratch_remove(&r->scratch);
    free(r);
}

static bool is_over(const struct added_run *run)
{
    return run->state != RUN_WAITING && run->state != RUN_RUNNING;
}

/* --- asking --------------------------------------------------------------------------------------------- */

/* How many runs are not over? Sets *same if one of them is of that point. */
static unsigned under_way(const struct added_runs *r, const struct live_study *study, struct digest key,
                          bool *same)
{
    unsigned count = 0;
    for (const struct added_run *run = r->first; run; run = run->later) {
        if (is_over(run))
            continue;
        count++;
        *same |= run->study == study && digest_equal(run->request.key, key);
    }
    return count;
}

/* Adds the run at the end, and forgets the oldest that are over. */
static void add(struct added_runs *r, struct added_run *run)
{
    struct added_run **at = &r->first;
    while (*at && r->count >= MOST_REMEMBERED) {
        if (is_over(*at))
            forget(r, at);
        else
            at = &(*at)->later;
    }
    for (at = &r->first; *at;)
        at = &(*at)->later;
    *at = run;
    r->count++;
}

static void prepare(struct added_runs *r, struct added_run *run)
{
    run->job = (struct pool_job){.name = run->request.name,
                                 .argv = run->request.argv,
                                 .dir = run->request.dir,
                                 .env = r->env,
                                 .limit_s = run->request.limit_s};
    add(r, run);
}

enum added_answer added_runs_ask(struct added_runs *r, struct live_study *study, const json_t *request,
                                 unsigned *id, char **error)
{
    struct point_request p = {0};
    struct point_request_places places = {r->places.runner, r->places.machines, r->scratch.path,
                                          r->latest + 1};
    bool same = false;
    if (!live_study_can_add(study, error) || !point_request_read(&p, study->note, request, &places, error))
        return ADDED_WRONG;
    unsigned waiting = under_way(r, study, p.key, &same);
    bool known = same || live_study_has(study, p.values, p.set);
    if (known || waiting >= ADDED_MOST_WAITING) {
        *error = same    ? xasprintf("%s is being run", p.name)
                 : known ? xasprintf("%s has a result already", p.name)
                         : xasprintf("%u runs wait already: stop some, or wait", waiting);
        point_request_clear(&p);
        return known ? ADDED_KNOWN : ADDED_TOO_MANY;
    }
    struct added_run *run = xcalloc(1, sizeof *run);
    *run = (struct added_run){.id = *id = ++r->latest, .study = study, .request = p};
    prepare(r, run);
    return ADDED_TAKEN;
}

bool added_runs_stop(struct added_runs *r, unsigned id)
{
    struct added_run *run = r->first;
    while (run && run->id != id)
        run = run->later;
    if (!run || is_over(run))
        return false;
    run->job.stop = true;
    if (run->state == RUN_WAITING)
        run->state = RUN_STOPPED;
    return true;
}

/* --- running -------------------------------------------------------------------------------------------- */

enum pool_next added_runs_next(struct added_runs *r, struct pool_job **job)
{
    for (struct added_run *run = r->first; run; run = run->later)
        if (run->state == RUN_WAITING) {
            run->state = RUN_RUNNING;
            *job = &run->job;
            return POOL_JOB;
        }
    return POOL_LATER;
}

/* The record for the journal. Sets the run's error if the run failed. */
static json_t *record_of(struct added_run *run)
{
    struct outcome o = outcome_of(&run->job, run->request.json, NULL);
    run->error = o.error ? xstrdup(o.error) : NULL;
    json_t *record = run->error ? point_record_of_failure(run->error, run->job.wall_time_s)
                                : point_record(&o, NULL, run->job.wall_time_s);
    json_set(record, "point", json_incref(run->request.values));
    json_set(record, "set", json_incref(run->request.set));
    outcome_clear(&o);
    return record;
}

void added_runs_ended(struct added_runs *r, struct pool_job *job)
{
    struct added_run *run = r->first;
    char *error = NULL;
    while (&run->job != job)
        run = run->later;
    if (job->stop || job->stopped) { /* as if it had not begun */
        run->state = RUN_STOPPED;
        unlink(run->request.json);
        return;
    }
    json_t *record = record_of(run);
    run->state = run->error ? RUN_FAILED : RUN_DONE;
    if (!live_study_add(run->study, run->request.key, record, r->places.notes, &error)) {
        fprintf(r->places.notes, "the result of %s is lost: %s\n", run->request.name, error);
        free(run->error);
        run->error = error;
        run->state = RUN_FAILED;
    }
    unlink(run->request.json);
    json_decref(record);
}

json_t *added_runs_json(const struct added_runs *r)
{
    json_t *list = json_array();
    for (const struct added_run *run = r->first; run; run = run->later)
        json_append(list,
                    json_pack("{s:i, s:o, s:s, s:s, s:o}", "id", (int)run->id, "study",
                              json_text(run->study->name), "name", run->request.name, "state",
                              STATES[run->state], "error", run->error ? json_text(run->error) : json_null()));
    return list;
}
