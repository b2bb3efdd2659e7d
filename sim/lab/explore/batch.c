/* batch.c - see batch.h. */
#include "lab/explore/batch.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "files/json_set.h"
#include "files/left_over.h"
#include "kernel/hostclock.h"
#include "kernel/xalloc.h"
#include "lab/explore/run_order.h"
#include "lab/jobs/own_folder.h"
#include "lab/jobs/process_pool.h"
#include "files/words.h"
#include "lab/study/point_run.h"

/* A run that is under way, and its files. */
struct task {
    struct planned_run *run; /* NULL: this slot is free */
    struct pool_job job;
    char *folder; /* stays for the next task of the slot */
    char *json, *record, *replay, *cfs, **argv;
};

struct doing {
    struct batch_place *place;
    struct planned_run *runs;
    size_t count, next, running;
    bool others; /* in this pass, some runs were locked */
    struct task *tasks;
    struct progress progress;
    char **env, *error;
};

struct planned_run planned_run(const struct subject *s, char *name, char *timing, char *schedule)
{
    struct planned_run r = {.name = name, .timing = timing, .schedule = schedule};
    r.key = subject_run_key(s, &(struct run_timing){timing, schedule});
    return r;
}

void planned_run_free(struct planned_run *r)
{
    free(r->name);
    free(r->timing);
    free(r->schedule);
    free(r->failure);
    json_decref(r->record);
    *r = (struct planned_run){0};
}

static char *key_path(const char *folder, struct digest key, const char *end)
{
    return xasprintf("%s/%s%s", folder, digest_text(key).text, end);
}

char *batch_recording(const struct batch_place *place, struct digest key)
{
    char *folder = xasprintf("%s/runs", place->dir), *path = key_path(folder, key, ".schedule");
    free(folder);
    return path;
}

/* --- progress ------------------------------------------------------------------------------------------- */

static void show(struct doing *d)
{
    const struct batch_place *p = d->place;
    double elapsed = hostclock_s() - p->begun_s;
    if (!d->progress.live)
        return;
    progress_end(&d->progress);
    fprintf(d->progress.to, "%zu of %zu runs, %zu running, %.1f runs/s", p->done, p->all, d->running,
            elapsed > 0 ? (double)p->run / elapsed : 0);
    fflush(d->progress.to);
}

/* --- a run's files -------------------------------------------------------------------------------------- */

static bool write_text(const char *path, const char *text)
{
    FILE *f = fopen(path, "we");
    if (!f)
        return false;
    bool good = fputs(text, f) >= 0;
    return !fclose(f) && good;
}

/* The name of the compared file in /cfs, such as "/result" of "/cfs/result"; NULL: it is not there. */
static const char *in_cfs(const struct subject *s)
{
    const char *file = s->options.compare_file;
    return file && !strncmp(file, "/cfs/", 5)   ? file + 4
           : file && !strncmp(file, "/pfs/", 5) ? file + 4
                                                : NULL;
}

static bool make_files(struct doing *d, struct task *t)
{
    const struct subject *s = d->place->subject;
    const char *scratch = d->place->scratch;
    if (!t->folder)
        t->folder = xasprintf("%s/.touchstone-%td", scratch, t - d->tasks);
    t->json = key_path(scratch, t->run->key, ".json");
    t->record = key_path(scratch, t->run->key, ".record");
    t->replay = t->run->schedule ? key_path(scratch, t->run->key, ".replay") : NULL;
    t->cfs = in_cfs(s) ? key_path(scratch, t->run->key, ".cfs") : NULL;
    if ((!t->replay || write_text(t->replay, t->run->schedule)) &&
        own_folder_make(t->folder, s->folder, s->options.compare_file, NULL))
        return true;
    d->error = xasprintf("%s: files for a run cannot be made: %m", scratch);
    return false;
}

static bool begin_task(struct doing *d, struct task *t, struct planned_run *run)
{
    *t = (struct task){.run = run, .folder = t->folder};
    d->running++;
    if (!make_files(d, t))
        return false;
    struct run_files f = {t->json, t->record, t->replay, t->cfs};
    t->argv = subject_command(d->place->subject, run->timing, &f);
    t->job = (struct pool_job){.name = run->name,
                               .argv = t->argv,
                               .dir = t->folder,
                               .env = d->env,
                               .in = d->place->subject->input,
                               .limit_s = d->place->limit_s};
    return true;
}

static void end_task(struct doing *d, struct task *t)
{
    char *files[] = {t->json, t->record, t->replay};
    point_locks_release(d->place->locks, t->run->key);
    if (t->cfs)
        left_over_remove(t->cfs);
    for (int i = 0; i < 3; i++)
        if (files[i])
            unlink(files[i]);
    pool_clear(&t->job, 1);
    words_free(t->argv);
    free(t->json);
    free(t->record);
    free(t->replay);
    free(t->cfs);
    *t = (struct task){.folder = t->folder};
    d->running--;
}

/* --- a result ------------------------------------------------------------------------------------------- */

/* The file by which runs are compared, as this run has left it; malloc'd, or NULL. */
static char *compared_file(const struct doing *d, const struct task *t)
{
    const struct subject *s = d->place->subject;
    const char *file = s->options.compare_file;
    if (!file)
        return NULL;
    return t->cfs ? xasprintf("%s%s", t->cfs, in_cfs(s)) : xasprintf("%s/%s", t->folder, file);
}

/* Notes in the record what a recording says of the whole run. */
static void note_order(json_t *record, const char *path)
{
    char *error = NULL;
    struct recording *r = recording_load(path, &error);
    if (r) {
        json_set(record, "order", digest_json(order_of_run(r)));
        json_set(record, "delays", json_integer((json_int_t)r->delays.count));
        json_set(record, "events", json_integer((json_int_t)(r->message_count + r->handler_count)));
    }
    recording_free(r);
    free(error);
}

/* Copies the run's recording to where it stays. */
static bool keep_recording(struct doing *d, const struct task *t, json_t *record)
{
    char *to = batch_recording(d->place, t->run->key), *text = NULL;
    size_t size = 0;
    FILE *in = fopen(t->record, "re");
    if (!in) { /* the run ended before there was anything to record */
        free(to);
        return true;
    }
    if (getdelim(&text, &size, '\0', in) < 0)
        text = xstrdup("");
    bool good = write_text(to, text);
    if (!good)
        d->error = xasprintf("%s cannot be written: %m", to);
    fclose(in);
    free(text);
    free(to);
    note_order(record, t->record);
    return good;
}

/* Where in the text touchstone says why the run has failed; NULL: nowhere. */
static const char *own_words(const char *text)
{
    static const char own[] = "touchstone run: ";
    const char *at = text;
    while ((at = strstr(at, own)) && at > text && at[-1] != '\n')
        at++;
    return at;
}

/* What the program wrote to standard error last, without what touchstone said of the failure. (A report so
 * long that its beginning is lost is all that is left.) */
static void set_stderr(json_t *record, const struct pool_job *job)
{
    const char *text = job->err ? job->err : "", *own = own_words(text);
    size_t length = own ? (size_t)(own - text) : strlen(text);
    if (!length || length == POOL_MAX_ERR)
        return;
    char *said = xstrndup(text, length);
    json_set(record, "stderr", json_text(said));
    free(said);
}

static json_t *record_of(struct doing *d, const struct task *t, enum journal_line_state *state)
{
    char *file = compared_file(d, t);
    json_t *record =
        t->job.cut ? NULL : verdict_of(d->place->rules, t->job.out ? t->job.out : "", t->json, file);
    *state = record ? LINE_DONE : LINE_FAILED;
    if (!record)
        record = point_record_of_failure(t->job.cut     ? POOL_CUT
                                         : t->job.error ? t->job.error
                                                        : "the run wrote no figures",
                                         t->job.wall_time_s);
    if (json_object_get(record, "message"))
        set_stderr(record, &t->job);
    json_set(record, "name", json_string(t->run->name));
    json_set(record, "wall_time_s", json_real(t->job.wall_time_s));
    free(file);
    return record;
}

static void ended(void *arg, struct pool_job *job)
{
    struct doing *d = arg;
    struct task *t = d->tasks;
    while (&t->job != job)
        t++;
    if (!job->stopped) { /* a stopped run counts as not begun */
        enum journal_line_state state;
        json_t *record = record_of(d, t, &state);
        /* not waiting for the disk: only a stop of the computer can lose the line, and runs are short */
        if (keep_recording(d, t, record) &&
            journal_add(d->place->journal, t->run->key, state, record, false, &d->error))
            d->place->run++, d->place->done++;
        json_decref(record);
    }
    end_task(d, t);
    show(d);
}

/* --- which is next -------------------------------------------------------------------------------------- */

static bool is_late(const struct doing *d)
{
    return d->place->deadline_s > 0 && hostclock_s() > d->place->deadline_s;
}

static enum pool_next begin(struct doing *d, struct planned_run *r, struct pool_job **job)
{
    struct task *t = d->tasks;
    while (t->run)
        t++;
    if (!begin_task(d, t, r)) {
        end_task(d, t);
        return POOL_NO_MORE;
    }
    *job = &t->job;
    return POOL_JOB;
}

static enum pool_next next(void *arg, struct pool_job **job)
{
    struct doing *d = arg;
    while (!d->error && !is_late(d) && d->next < d->count) {
        struct planned_run *r = &d->runs[d->next++];
        if (journal_find(d->place->journal, r->key, NULL))
            continue;
        if (!point_locks_take(d->place->locks, r->key)) {
            d->others = true;
            continue;
        }
        journal_refresh(d->place->journal); /* the lock's last owner may have run it */
        if (!journal_find(d->place->journal, r->key, NULL))
            return begin(d, r, job);
        point_locks_release(d->place->locks, r->key);
    }
    if (d->error || is_late(d) || !d->others)
        return POOL_NO_MORE;
    d->next = 0;
    d->others = false;
    journal_refresh(d->place->journal);
    return POOL_LATER;
}

static void second(void *arg)
{
    show(arg);
}

/* --- all ------------------------------------------------------------------------------------------------ */

static void take_results(struct doing *d)
{
    for (size_t i = 0; i < d->count; i++) {
        struct planned_run *r = &d->runs[i];
        r->record = journal_record(d->place->journal, r->key);
        const char *failure = json_string_value(json_object_get(r->record, "failure"));
        if (failure) {
            r->failure = xstrdup(failure);
            json_decref(r->record);
            r->record = NULL;
        }
    }
}

static size_t results_of(const struct doing *d)
{
    size_t with = 0;
    for (size_t i = 0; i < d->count; i++)
        with += journal_find(d->place->journal, d->runs[i].key, NULL);
    return with;
}

bool batch_do(struct batch_place *place, struct planned_run *runs, size_t count, char **error)
{
    struct doing d = {.place = place, .runs = runs, .count = count, .progress = progress_to(place->notes)};
    struct pool_source source = {.next = next, .ended = ended, .second = second, .arg = &d};
    d.tasks = xcalloc(place->at_once, sizeof *d.tasks);
    d.env = point_run_environment(place->scratch);
    journal_refresh(place->journal);
    size_t done = place->done, before = results_of(&d);
    place->before += before;
    place->done += before;
    struct pool_end end = {0};
    if (before < count)
        end = pool_run_from(&source, place->at_once);
    progress_end(&d.progress);
    place->done = done + results_of(&d);
    place->signal = end.stopped;
    take_results(&d);
    words_free(d.env);
    for (unsigned i = 0; i < place->at_once; i++)
        free(d.tasks[i].folder);
    free(d.tasks);
    *error = d.error;
    return !d.error && !end.stopped;
}
