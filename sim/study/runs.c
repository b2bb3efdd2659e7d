/* runs.c - see runs.h. */
#include "study/runs.h"
#include "study/pool.h"
#include "study/progress.h"
#include "study/tables.h"
#include "study/text.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A run's command line: argv and the texts that are its own. */
struct command {
    char *argv[10 + 2 * RUN_MAX_SETTINGS + PAPER_MAX_ARGS + RUN_MAX_EXTRA + 1];
    char *program, *nodes, *json, *arguments;
};

static void build_command(struct command *c, const struct tables_options *o, const struct paper *paper,
                          const struct run *run, size_t i, const char *scratch)
{
    c->program = text_of("%s/%s", o->programs, paper->program);
    c->nodes = text_of("%u", run->nodes);
    c->json = text_of("%s/%zu.json", scratch, i);
    c->arguments = text_of("%s", run->arguments);
    char *const head[] = {(char *)o->runner, "run",    "-q",   "-m", paper->machine, "-n",
                          c->nodes,          "--json", c->json};
    size_t n = sizeof head / sizeof *head;
    memcpy(c->argv, head, sizeof head);
    for (char *const *set = run->settings; *set; set++) {
        c->argv[n++] = "--set";
        c->argv[n++] = *set;
    }
    c->argv[n++] = c->program;
    char *save, *word = strtok_r(c->arguments, " ", &save);
    for (size_t end = n + PAPER_MAX_ARGS; word && n < end; word = strtok_r(NULL, " ", &save))
        c->argv[n++] = word;
    if (run->extra)
        c->argv[n++] = (char *)run->extra;
    c->argv[n] = NULL;
}

static void free_command(struct command *c)
{
    unlink(c->json);
    free(c->program);
    free(c->nodes);
    free(c->json);
    free(c->arguments);
}

static void read_outcome(struct run *run, const struct pool_job *job, const char *json)
{
    if (job->state == POOL_DONE)
        run->outcome = outcome_read(job->out, json, "total_s");
    else
        run->outcome.error = strdup(job->error ? job->error : "not run");
    run->outcome.wall_time_s = job->wall_time_s;
}

static bool do_in(const struct tables_options *o, const struct paper *paper, struct run runs[], size_t count,
                  const char *scratch, double *wall_s)
{
    struct command *commands = calloc(count + 1, sizeof *commands);
    struct pool_job *jobs = calloc(count + 1, sizeof *jobs);
    if (!commands || !jobs)
        abort();
    for (size_t i = 0; i < count; i++) {
        build_command(&commands[i], o, paper, &runs[i], i, scratch);
        jobs[i] = (struct pool_job){.name = runs[i].name, .argv = commands[i].argv, .weight = runs[i].weight};
    }
    struct progress progress;
    struct pool_watcher watcher = progress_watcher(&progress, o->progress);
    struct pool_end end = pool_run(jobs, count, o->at_once, &watcher);
    progress_end(&progress);
    for (size_t i = 0; i < count; i++) {
        read_outcome(&runs[i], &jobs[i], commands[i].json);
        free_command(&commands[i]);
    }
    pool_clear(jobs, count);
    free(jobs);
    free(commands);
    *wall_s += end.wall_time_s;
    return !end.stopped;
}

bool runs_do(const struct tables_options *o, const struct paper *paper, struct run runs[], size_t count,
             double *wall_s, char **error)
{
    const char *tmp = getenv("TMPDIR");
    char *scratch = text_of("%s/touchstone-tables.XXXXXX", tmp && *tmp ? tmp : "/tmp");
    bool ok = mkdtemp(scratch);
    if (!ok)
        *error = text_of("%s cannot be made: %s", scratch, strerror(errno));
    else if (!(ok = do_in(o, paper, runs, count, scratch, wall_s)))
        *error = text_of("stopped; nothing was written");
    rmdir(scratch);
    free(scratch);
    return ok;
}

void runs_clear(struct run runs[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        outcome_clear(&runs[i].outcome);
        free(runs[i].name);
        for (char **set = runs[i].settings; *set; set++)
            free(*set);
    }
}
