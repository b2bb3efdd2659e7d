/* study_run.c - runs the points of a study that have no result yet; see study.h.
 *
 * Points are taken in the order of descending cost. Each point is locked, looked up in the journal again
 * (another process may have run it), then in the result cache, and then run. A point that another process has
 * locked is looked at again until it has a result or its lock is free.
 */
#include "files/json_set.h"
#include "kernel/hostclock.h"
#include "kernel/xalloc.h"
#include "lab/jobs/process_pool.h"
#include "lab/jobs/progress.h"
#include "lab/jobs/result_cache.h"
#include "lab/study/point_run.h"
#include "lab/study/study_note.h"
#include "lab/study/study_parts.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A point that is being run. */
struct task {
    bool used;
    const struct work *work;
    struct pool_job job;
    json_t *inputs;
    char *name, **argv, *json, *profile;
};

struct study_session {
    struct study *study;
    struct task *tasks; /* at_once of them */
    size_t running;
    size_t next; /* index in study->work */
    bool others; /* in this pass, some points were locked */
    size_t have; /* points with a result */
    double begun_s, cost_left, cost_done;
    struct progress progress;
    char **env;
    bool unnamed; /* the user was told of a file that is not among the inputs */
    bool refused; /* and that the result cache took no result: it is offered no others */
    char *error;  /* the journal cannot be written: no more points are run */
};

/* --- how it is getting on ------------------------------------------------------------------------------- */

static struct progress_counts counts_of(const struct study_session *e)
{
    const struct study_counts *c = &e->study->counts;
    double elapsed = hostclock_s() - e->begun_s;
    return (struct progress_counts){.all = e->study->count,
                                    .done = e->have - c->failed,
                                    .running = e->running,
                                    .failed = c->failed,
                                    .cached = c->cached,
                                    .left_s = e->cost_left <= 0   ? 0
                                              : e->cost_done <= 0 ? -1
                                                                  : elapsed * e->cost_left / e->cost_done};
}

/* Counts the points that have a result in the journal, those of other processes included. */
static void count(struct study_session *e)
{
    struct study *s = e->study;
    double left = 0;
    e->have = s->counts.failed = 0;
    for (size_t i = 0; i < s->count; i++) {
        enum journal_line_state state;
        bool has = journal_find(s->journal, s->work[i].key, &state);
        e->have += has;
        s->counts.failed += has && state == LINE_FAILED;
        left += has ? 0 : s->work[i].cost;
    }
    if (e->cost_left > left)
        e->cost_done += e->cost_left - left;
    e->cost_left = left;
}

/* One more point has a result. */
static void count_one(struct study_session *e, const struct work *w, bool failed)
{
    e->have++;
    e->study->counts.failed += failed;
    e->cost_left -= w->cost;
}

/* --- a result ------------------------------------------------------------------------------------------- */

static bool write_down(struct study_session *e, const struct work *w, enum journal_line_state state,
                       json_t *record, bool safe)
{
    struct point p;
    char *error = NULL;
    if (point_make(e->study->spec, w->number, &p, &error) ==
        POINT_WANTED) /* always so: plan() has checked all points */
        json_set(record, "point", point_values(e->study->spec, &p));
    free(error);
    return journal_add(e->study->journal, w->key, state, record, safe, &e->error);
}

/* Did the program open a file of the host that the study does not name? Then its results may depend on more
 * than the inputs. */
static bool depends_on_unnamed(struct study_session *e, const json_t *run)
{
    size_t i;
    json_t *name;
    json_array_foreach(json_object_get(run, "host_files"), i, name)
    {
        const char *file = json_string_value(name);
        bool named = false;
        for (const char **input = e->study->spec->inputs; !named && *input; input++)
            named = strcmp(*input, file) == 0;
        if (named)
            continue;
        progress_end(&e->progress);
        if (!e->unnamed && e->study->options.cache)
            fprintf(
                e->progress.to,
                "the program opens %s, which is not among the study's inputs: results are not kept in the "
                "cache\n",
                file);
        e->unnamed = true;
        return true;
    }
    return false;
}

/* Writes the result of the task's run to the journal and the result cache. */
static void record_end(struct study_session *e, struct task *t)
{
    struct study *s = e->study;
    struct outcome o = outcome_of(&t->job, t->json, NULL);
    const char *error = o.error;
    bool keep = !error && s->options.cache && !depends_on_unnamed(e, o.run) && !e->refused;
    json_t *record = error ? point_record_of_failure(error, t->job.wall_time_s)
                           : point_record(&o, t->profile, t->job.wall_time_s);
    if (keep)
        e->refused =
            !result_cache_add(s->options.cache, t->work->key, t->inputs, record, s->options.progress);
    if (write_down(e, t->work, error ? LINE_FAILED : LINE_DONE, record, true)) {
        s->counts.run++;
        e->cost_done += t->work->cost;
        count_one(e, t->work, error);
        struct progress_counts counts = counts_of(e);
        progress_ended(&e->progress, &counts, t->name, error, t->job.wall_time_s);
    }
    json_decref(record);
    outcome_clear(&o);
}

/* --- running -------------------------------------------------------------------------------------------- */

static void begin_task(struct study_session *e, struct task *t, const struct work *w, const struct point *p,
                       json_t *inputs)
{
    const struct study *s = e->study;
    *t = (struct task){.used = true, .work = w, .inputs = inputs, .name = point_name(s->spec, p)};
    t->json = xasprintf("%s/%lu.json", s->scratch.path, w->number);
    t->profile = s->spec->profile ? xasprintf("%s/%lu.profile", s->scratch.path, w->number) : NULL;
    struct point_run_files files = {s->options.runner, s->program, t->json, t->profile};
    t->argv = point_run_argv(s->spec, s->inputs, p, &files);
    t->job = (struct pool_job){.name = t->name,
                               .argv = t->argv,
                               .dir = s->dir,
                               .env = e->env,
                               /* a run ends itself at its limit, with a better message; this is for one that
                                * cannot */
                               .limit_s = s->spec->max_wall_s > 0 ? s->spec->max_wall_s + 2 : 0};
    e->running++;
}

static void end_task(struct study_session *e, struct task *t)
{
    point_locks_release(e->study->locks, t->work->key);
    unlink(t->json);
    if (t->profile)
        unlink(t->profile);
    pool_clear(&t->job, 1);
    json_decref(t->inputs);
    words_free(t->argv);
    free(t->name);
    free(t->json);
    free(t->profile);
    *t = (struct task){0};
}

static void ended(void *arg, struct pool_job *job)
{
    struct study_session *e = arg;
    struct task *t = e->tasks;
    while (&t->job != job)
        t++;
    e->running--;
    if (!job->stopped) /* a stopped run counts as not begun */
        record_end(e, t);
    end_task(e, t);
}

/* --- which is next -------------------------------------------------------------------------------------- */

static struct task *free_task(const struct study_session *e)
{
    struct task *t = e->tasks;
    while (t->used)
        t++;
    return t;
}

/* Takes the point's result from the result cache. False if there is none. */
static bool fetch(struct study_session *e, const struct work *w, const json_t *inputs)
{
    struct study *s = e->study;
    json_t *record =
        s->options.cache ? result_cache_find(s->options.cache, w->key, inputs, s->options.progress) : NULL;
    if (!record)
        return false;
    json_set(record, "cached", json_true());
    /* need not be safe: a lost line is found in the cache again */
    if (write_down(e, w, LINE_DONE, record, false)) {
        s->counts.cached++;
        count_one(e, w, false);
    }
    json_decref(record);
    return true;
}

/* Starts a point that is locked and has no result. */
static enum pool_next begin(struct study_session *e, const struct work *w, struct pool_job **job)
{
    struct study *s = e->study;
    struct point p;
    struct digest key;
    json_t *inputs = NULL;
    if (point_make(s->spec, w->number, &p, &e->error) != POINT_WANTED ||
        !inputs_of(s->inputs, &p, &key, &inputs, &e->error))
        return POOL_NO_MORE;
    if (fetch(e, w, inputs)) {
        point_locks_release(s->locks, w->key);
        json_decref(inputs);
        return POOL_AGAIN;
    }
    struct task *t = free_task(e);
    begin_task(e, t, w, &p, inputs);
    *job = &t->job;
    return POOL_JOB;
}

static enum pool_next next(void *arg, struct pool_job **job)
{
    struct study_session *e = arg;
    struct study *s = e->study;
    while (!e->error && e->next < s->count) {
        const struct work *w = &s->work[e->next++];
        if (journal_find(s->journal, w->key, NULL))
            continue;
        if (!point_locks_take(s->locks, w->key)) {
            e->others = true;
            continue;
        }
        journal_refresh(s->journal); /* the lock's last owner may have run the point */
        if (!journal_find(s->journal, w->key, NULL))
            return begin(e, w, job);
        point_locks_release(s->locks, w->key);
    }
    if (e->error || !e->others)
        return POOL_NO_MORE;
    e->next = 0;
    e->others = false;
    journal_refresh(s->journal);
    return POOL_LATER;
}

static void second(void *arg)
{
    struct study_session *e = arg;
    if (*e->study->options.session) {
        journal_refresh(e->study->journal);
        count(e);
    }
    struct progress_counts counts = counts_of(e);
    progress_show(&e->progress, &counts);
}

enum study_end study_run(struct study *s, char **error)
{
    struct study_session e = {
        .study = s, .begun_s = hostclock_s(), .progress = progress_to(s->options.progress)};
    struct pool_source source = {.next = next, .ended = ended, .second = second, .arg = &e};
    e.tasks = xcalloc(s->options.at_once, sizeof *e.tasks);
    e.env = point_run_environment(s->scratch.path);
    study_estimate(s);
    study_sort(s, true);
    count(&e);
    e.cost_done = 0;
    s->counts.before = e.have;
    struct pool_end end = {0};
    if (study_note_write(s, &e.error))
        end = pool_run_from(&source, s->options.at_once);
    progress_end(&e.progress);
    count(&e);
    s->counts.signal = end.stopped;
    words_free(e.env);
    free(e.tasks);
    *error = e.error;
    return e.error ? STUDY_ERROR : end.stopped ? STUDY_STOPPED : STUDY_DONE;
}
