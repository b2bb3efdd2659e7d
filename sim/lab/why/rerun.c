/* rerun.c - see rerun.h: the children. */
#include "lab/why/rerun.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "files/folder_make.h"
#include "kernel/xalloc.h"
#include "lab/jobs/outcome.h"
#include "lab/jobs/process_pool.h"
#include "lab/jobs/progress.h"
#include "lab/why/rerun_changes.h"

/* A child: its command line, and the texts that it owns. */
struct child {
    char **argv;
    char *json, *cfs;
};

static size_t length(char *const *list)
{
    size_t count = 0;
    while (list && list[count])
        count++;
    return count;
}

/* The command with the settings behind its own, so that they count. */
static struct child child_of(const struct rerun_command *c, const struct rerun *x, const char *scratch,
                             size_t i)
{
    size_t options = length(c->options), program = length(c->program), settings = length(x->set);
    struct child child = {.argv = xcalloc(options + 2 * settings + program + 5, sizeof(char *))};
    char **word = child.argv;
    child.json = xasprintf("%s/%zu.json", scratch, i);
    child.cfs = c->cfs ? xasprintf("%s/%zu.cfs", scratch, i) : NULL;
    for (size_t k = 0; k < options; k++)
        *word++ = c->options[k];
    for (size_t k = 0; k < settings; k++)
        *word++ = (char *)(uintptr_t) "--set", *word++ = x->set[k];
    *word++ = (char *)(uintptr_t) "--json", *word++ = child.json;
    if (c->cfs)
        *word++ = (char *)(uintptr_t) "--cfs", *word++ = child.cfs;
    memcpy(word, c->program, program * sizeof *word);
    return child;
}

static void free_child(struct child *c)
{
    free(c->argv);
    free(c->json);
    free(c->cfs);
}

/* --- results --- */

/* A text of several lines in one. */
static char *in_one_line(const char *text)
{
    char *line = xstrdup(text);
    for (char *at = line; *at; at++)
        if (*at == '\n')
            *at = at[1] ? ' ' : '\0';
    return line;
}

static void take_result(struct rerun *x, const struct pool_job *job, const char *json)
{
    if (job->state != POOL_DONE) {
        x->error = in_one_line(job->error ? job->error : "not run");
        return;
    }
    struct outcome o = outcome_read(job->out, json, NULL);
    double seconds = figure_of(o.run, "virtual_time_s");
    if (isnan(seconds))
        x->error = in_one_line(o.error ? o.error : "the run left no figures");
    else
        x->done = true, x->end = (vtime)llround(seconds * (double)VT_SECOND);
    outcome_clear(&o);
}

/* --- copies of the folder for /cfs --- */

static bool copy_cfs(const struct trace *t, const char *from, const struct child *children, size_t count,
                     char **error)
{
    struct pool_job *jobs = xcalloc(count, sizeof *jobs);
    char *(*argv)[6] = xcalloc(count, sizeof *argv);
    for (size_t i = 0; i < count; i++) {
        char *const words[6] = {(char *)(uintptr_t) "cp", (char *)(uintptr_t) "-a", (char *)(uintptr_t) "--",
                                (char *)(uintptr_t)from,  children[i].cfs,          NULL};
        memcpy(argv[i], words, sizeof words);
        jobs[i] = (struct pool_job){.name = "cp", .argv = argv[i], .weight = 1, .dir = t->folder};
    }
    bool all = pool_run(jobs, count, 1, NULL).all_done;
    for (size_t i = 0; i < count && !*error; i++)
        if (jobs[i].state != POOL_DONE)
            *error = xasprintf("%s, the files of /cfs, cannot be copied: %s", from,
                               jobs[i].error ? jobs[i].error : "stopped");
    pool_clear(jobs, count);
    free(jobs);
    free(argv);
    return all;
}

/* --- running --- */

static bool run(const struct trace *t, const struct rerun_options *o, struct reruns *r,
                const struct child *children, size_t first, size_t count)
{
    struct pool_job *jobs = xcalloc(count, sizeof *jobs);
    struct progress progress = {0};
    for (size_t i = 0; i < count; i++)
        jobs[i] = (struct pool_job){
            .name = r->list[first + i].what, .argv = children[first + i].argv, .weight = 1, .dir = t->folder};
    struct pool_watcher watcher = progress_watcher(&progress, o->progress);
    struct pool_end end = pool_run(jobs, count, o->at_once, &watcher);
    progress_end(&progress);
    for (size_t i = 0; i < count; i++)
        take_result(&r->list[first + i], &jobs[i], children[first + i].json);
    pool_clear(jobs, count);
    free(jobs);
    return !end.stopped;
}

/* Is the run still that of the trace? */
static bool is_same(const struct trace *t, const struct rerun *x, char **error)
{
    if (!x->done)
        *error = xasprintf("the command of the trace cannot be run again: %s", x->error);
    else if (x->end != t->end)
        *error = xasprintf(
            "the command of the trace takes %.12f s now, not %.12f s: the program, its input or the "
            "machine file has changed since; make the trace anew",
            vt_seconds(x->end), vt_seconds(t->end));
    return !*error;
}

static bool run_in(const struct trace *t, const struct rerun_options *o, struct reruns *r,
                   const char *scratch, char **error)
{
    struct child *children = xcalloc(r->count, sizeof *children);
    for (size_t i = 0; i < r->count; i++)
        children[i] = child_of(&o->command, &r->list[i], scratch, i);
    bool ok = (!o->command.cfs || copy_cfs(t, o->command.cfs, children, r->count, error)) &&
              run(t, o, r, children, 0, 1) && is_same(t, &r->list[0], error) &&
              run(t, o, r, children, 1, r->count - 1);
    if (!ok && !*error)
        *error = xstrdup("stopped");
    for (size_t i = 0; i < r->count; i++)
        free_child(&children[i]);
    free(children);
    return ok;
}

bool rerun_all(const struct trace *t, const struct rerun_options *o, struct reruns *r, char **error)
{
    *error = NULL;
    *r = rerun_changes(t, o);
    struct scratch scratch = folder_scratch("touchstone-why", error);
    bool ok = scratch.path && run_in(t, o, r, scratch.path, error);
    scratch_remove(&scratch);
    return ok;
}

void reruns_free(struct reruns *r)
{
    for (size_t i = 0; i < r->count; i++) {
        for (char **s = r->list[i].set; s && *s; s++)
            free(*s);
        free(r->list[i].set);
        free(r->list[i].what);
        free(r->list[i].key);
        free(r->list[i].error);
    }
    free(r->list);
    *r = (struct reruns){0};
}
