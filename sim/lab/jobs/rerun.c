/* rerun.c - see rerun.h: the children. */
#include "lab/jobs/rerun.h"
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/jobs/outcome.h"
#include "lab/jobs/own_folder.h"
#include "lab/jobs/process_pool.h"
#include "lab/jobs/progress.h"
#include "files/words.h"

struct child {
    char **argv;
    char *json, *cfs, *folder; /* folder NULL: the command's */
};

/* The copy of the folder for /cfs; malloc'd. NULL: the command names none. */
static char *cfs_of(const struct rerun_place *p, size_t i)
{
    return p->command.cfs ? xasprintf("%s/%zu.cfs", p->scratch, i) : NULL;
}

/* The command with the settings behind its own, so that they count. */
static struct child child_of(const struct rerun_place *p, const struct rerun *x, size_t i)
{
    const struct rerun_command *c = &p->command;
    struct child child = {.json = xasprintf("%s/%zu.json", p->scratch, i), .cfs = cfs_of(p, i)};
    child.folder = p->apart ? xasprintf("%s/%zu", p->scratch, i) : NULL;
    words_add_each(&child.argv, NULL, (const char *const *)c->options);
    words_add_each(&child.argv, "--set", (const char *const *)x->set);
    words_add_option(&child.argv, "--json", xstrdup(child.json));
    if (child.cfs)
        words_add_option(&child.argv, "--cfs", xstrdup(child.cfs));
    words_add_each(&child.argv, NULL, (const char *const *)c->program);
    return child;
}

static void free_child(struct child *c)
{
    words_free(c->argv);
    free(c->json);
    free(c->cfs);
    free(c->folder);
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

bool rerun_time(const char *json, vtime *end, char **error)
{
    struct outcome o = outcome_read("", json, NULL);
    double seconds = figure_of(o.run, "virtual_time_s");
    bool found = !isnan(seconds);
    if (found)
        *end = (vtime)llround(seconds * (double)VT_SECOND);
    else
        *error = in_one_line(o.error ? o.error : "the run left no figures");
    outcome_clear(&o);
    return found;
}

static void take_result(struct rerun *x, const struct pool_job *job, const char *json)
{
    if (job->state != POOL_DONE)
        x->error = in_one_line(job->error ? job->error : "not run");
    else
        x->done = rerun_time(json, &x->end, &x->error);
}

/* --- copies of the folder for /cfs --- */

bool rerun_copy_cfs(const struct rerun_place *p, const struct reruns *r, char **error)
{
    if (!p->command.cfs)
        return true;
    struct pool_job *jobs = xcalloc(r->count, sizeof *jobs);
    char ***argv = xcalloc(r->count, sizeof *argv);
    for (size_t i = 0; i < r->count; i++) {
        words_add_each(&argv[i], NULL, (const char *const[]){"cp", "-a", "--", p->command.cfs, NULL});
        words_add(&argv[i], cfs_of(p, i));
        jobs[i] = (struct pool_job){.name = "cp", .argv = argv[i], .weight = 1, .dir = p->command.folder};
    }
    bool all = pool_run(jobs, r->count, 1, NULL).all_done;
    for (size_t i = 0; i < r->count; i++) {
        if (jobs[i].state != POOL_DONE && !*error)
            *error = xasprintf("%s, the files of /cfs, cannot be copied: %s", p->command.cfs,
                               jobs[i].error ? jobs[i].error : "stopped");
        words_free(argv[i]);
    }
    pool_clear(jobs, r->count);
    free(jobs);
    free(argv);
    return all;
}

/* --- running --- */

static bool make_folders(const struct rerun_place *p, const struct child *children, size_t count,
                         char **error)
{
    for (size_t i = 0; i < count && p->apart; i++)
        if (!own_folder_make(children[i].folder, p->command.folder, NULL, p->apart)) {
            *error = xasprintf("%s cannot be made: %m", children[i].folder);
            return false;
        }
    return true;
}

/* Returns the signal that has stopped them; 0: none. */
static int run(const struct rerun_place *p, struct rerun *list, const struct child *children, size_t count)
{
    struct pool_job *jobs = xcalloc(count, sizeof *jobs);
    struct progress progress = {0};
    for (size_t i = 0; i < count; i++)
        jobs[i] = (struct pool_job){.name = list[i].what,
                                    .argv = children[i].argv,
                                    .weight = 1,
                                    .dir = children[i].folder ? children[i].folder : p->command.folder,
                                    .in = p->command.in};
    struct pool_watcher watcher =
        p->progress ? progress_watcher(&progress, p->progress) : (struct pool_watcher){0};
    struct pool_end end = pool_run(jobs, count, p->at_once, p->progress ? &watcher : NULL);
    if (p->progress)
        progress_end(&progress);
    for (size_t i = 0; i < count; i++)
        take_result(&list[i], &jobs[i], children[i].json);
    pool_clear(jobs, count);
    free(jobs);
    return end.stopped;
}

bool rerun_some(const struct rerun_place *p, struct reruns *r, size_t first, size_t count, char **error)
{
    struct child *children = xcalloc(count, sizeof *children);
    for (size_t i = 0; i < count; i++)
        children[i] = child_of(p, &r->list[first + i], first + i);
    bool ok = make_folders(p, children, count, error);
    if (ok && (r->stopped = run(p, &r->list[first], children, count))) {
        *error = xstrdup("stopped");
        ok = false;
    }
    for (size_t i = 0; i < count; i++)
        free_child(&children[i]);
    free(children);
    return ok;
}

struct rerun *reruns_add(struct reruns *r, const char *key, char *what)
{
    r->list = xreallocarray(r->list, r->count + 1, sizeof *r->list);
    r->list[r->count] = (struct rerun){.what = what, .key = xstrdup(key)};
    return &r->list[r->count++];
}

void reruns_free(struct reruns *r)
{
    for (size_t i = 0; i < r->count; i++) {
        words_free(r->list[i].set);
        free(r->list[i].what);
        free(r->list[i].key);
        free(r->list[i].error);
    }
    free(r->list);
    *r = (struct reruns){0};
}
