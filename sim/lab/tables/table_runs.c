/* table_runs.c - see table_runs.h. */
#include "lab/tables/table_runs.h"
#include "files/folder_make.h"
#include "kernel/xalloc.h"
#include "lab/jobs/process_pool.h"
#include "lab/jobs/progress.h"
#include "files/words.h"
#include "lab/tables/runs_journal.h"
#include "lab/tables/tables.h"

#include <stdlib.h>
#include <unistd.h>

struct command {
    char **argv, *json;
};

static struct command command_of(const struct tables_options *o, const struct paper *paper,
                                 const struct run *run, size_t i, const char *scratch)
{
    struct command c = {.json = xasprintf("%s/%zu.json", scratch, i)};
    words_add_each(&c.argv, NULL, (const char *const[]){o->runner, "run", "-q", "-m", paper->machine, NULL});
    words_add_option(&c.argv, "-n", xasprintf("%u", run->nodes));
    words_add_option(&c.argv, "--json", xstrdup(c.json));
    words_add_each(&c.argv, "--set", (const char *const *)run->settings);
    words_add(&c.argv, xasprintf("%s/%s", o->programs, paper->program));
    words_add_all(&c.argv, xstrdup(run->arguments));
    if (run->extra)
        words_add_all(&c.argv, xstrdup(run->extra));
    return c;
}

static void free_command(struct command *c)
{
    unlink(c->json);
    words_free(c->argv);
    free(c->json);
}

/* --- running -------------------------------------------------------------------------------------------- */

struct doing {
    struct run *runs;
    struct command *commands;
    struct pool_job *jobs; /* of the runs that are not in the journal */
    size_t *which;         /* the run of each job */
    size_t count;
    struct runs_journal *journal; /* NULL: none */
    struct progress progress;
    struct pool_watcher shown;
    struct runs_watcher watcher;
};

/* What the watcher writes stands in place of the terminal's line, which returns within a second. */
static void tell(struct doing *d)
{
    progress_end(&d->progress);
    if (d->watcher.changed)
        d->watcher.changed(d->watcher.arg);
}

/* After a run's end: reads its outcome and adds it to the journal, before the next run starts. */
static void changed(void *arg, const struct pool_status *status)
{
    struct doing *d = arg;
    d->shown.changed(d->shown.arg, status);
    if (status->finished && status->finished->state != POOL_WAITING) {
        size_t job = (size_t)(status->finished - d->jobs), i = d->which[job];
        d->runs[i].outcome = outcome_of(status->finished, d->commands[i].json, "total_s");
        if (d->journal && !d->runs[i].outcome.error)
            runs_journal_add(d->journal, &d->runs[i]);
        if (!status->finished->stopped) /* a table with what was stopped is none */
            tell(d);
    }
}

static bool do_in(const struct tables_options *o, const struct paper *paper, struct run runs[], size_t count,
                  const char *scratch, struct runs_journal *journal, struct runs_watcher told, double *wall_s)
{
    struct doing d = {.runs = runs, .journal = journal, .watcher = told};
    d.commands = xcalloc(count + 1, sizeof *d.commands);
    d.jobs = xcalloc(count + 1, sizeof *d.jobs);
    d.which = xcalloc(count + 1, sizeof *d.which);
    for (size_t i = 0; i < count; i++) {
        d.commands[i] = command_of(o, paper, &runs[i], i, scratch);
        if (journal && runs_journal_find(journal, &runs[i]))
            continue;
        d.jobs[d.count] = (struct pool_job){
            .name = runs[i].name, .argv = d.commands[i].argv, .turn = runs[i].turn, .weight = runs[i].weight};
        d.which[d.count++] = i;
    }
    if (d.count < count)
        fprintf(o->progress, "%zu of %zu runs are in %s/journal\n", count - d.count, count, o->dir);
    d.shown = progress_watcher(&d.progress, o->progress);
    tell(&d);
    struct pool_watcher watcher = {changed, &d};
    struct pool_end end = pool_run(d.jobs, d.count, o->at_once, &watcher);
    progress_end(&d.progress);
    for (size_t i = 0; i < count; i++)
        free_command(&d.commands[i]);
    pool_clear(d.jobs, d.count);
    free(d.jobs);
    free(d.which);
    free(d.commands);
    *wall_s += end.wall_time_s;
    *o->signal = end.stopped;
    return !end.stopped;
}

bool table_runs_do(const struct tables_options *o, const struct paper *paper, struct run runs[], size_t count,
                   struct runs_watcher watcher, double *wall_s, char **error)
{
    struct runs_journal *journal = o->resume ? runs_journal_open(o, paper, error) : NULL;
    struct scratch scratch = {NULL, -1};
    if (!o->resume || journal)
        scratch = folder_scratch("touchstone-tables", error);
    bool ok = scratch.path && do_in(o, paper, runs, count, scratch.path, journal, watcher, wall_s);
    if (scratch.path && !ok)
        *error = o->resume ? xasprintf("stopped; the same command goes on from %s/journal", o->dir)
                           : xasprintf("stopped; nothing was written");
    scratch_remove(&scratch);
    runs_journal_close(journal);
    return ok;
}

void table_runs_clear(struct run runs[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        outcome_clear(&runs[i].outcome);
        free(runs[i].name);
        words_free(runs[i].settings);
    }
}
