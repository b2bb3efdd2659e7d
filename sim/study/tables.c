/* tables.c - from the paper's rows to runs, through the pool, to results; see tables.h. */
#include "study/tables.h"
#include "study/folder.h"
#include "study/pool.h"
#include "study/progress.h"
#include "study/results.h"
#include "study/text.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void *zeroed(size_t count, size_t size)
{
    void *p = calloc(count + 1, size);
    if (!p)
        abort();
    return p;
}

/* --- running them ---------------------------------------------------------------------------------------- */

/* A run's command line, in one allocation's worth of parts: argv and the texts that are its own. */
struct command {
    char *argv[10 + PAPER_MAX_ARGS + 1];
    char *program, *nodes, *json, *arguments;
};

static void build_command(struct command *c, const struct tables_options *o, const struct results *r,
                          size_t i, const char *scratch)
{
    const struct run *run = &r->runs[i];
    c->program = text_of("%s/%s", o->programs, r->paper->program);
    c->nodes = text_of("%u", run->nodes);
    c->json = text_of("%s/%zu.json", scratch, i);
    c->arguments = text_of("%s", run->arguments);
    char *const head[] = {(char *)o->runner, "run",    "-q",    "-m",      r->paper->machine, "-n",
                          c->nodes,          "--json", c->json, c->program};
    size_t n = sizeof head / sizeof *head;
    memcpy(c->argv, head, sizeof head);
    char *save, *word = strtok_r(c->arguments, " ", &save);
    for (size_t end = n + PAPER_MAX_ARGS; word && n < end; word = strtok_r(NULL, " ", &save))
        c->argv[n++] = word;
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

/* Runs all; false when a signal stopped it. */
static bool run_all(const struct tables_options *o, struct results *r, const char *scratch)
{
    struct command *commands = zeroed(r->run_count, sizeof *commands);
    struct pool_job *jobs = zeroed(r->run_count, sizeof *jobs);
    for (size_t i = 0; i < r->run_count; i++) {
        build_command(&commands[i], o, r, i, scratch);
        jobs[i] =
            (struct pool_job){.name = r->runs[i].name, .argv = commands[i].argv, .weight = r->runs[i].weight};
    }

    struct progress progress;
    struct pool_watcher watcher = progress_watcher(&progress, o->progress);
    struct pool_end end = pool_run(jobs, r->run_count, o->at_once, &watcher);
    progress_end(&progress);

    for (size_t i = 0; i < r->run_count; i++) {
        struct outcome *outcome = &r->runs[i].outcome;
        if (jobs[i].state == POOL_DONE)
            *outcome = outcome_read(jobs[i].out, commands[i].json, "total_s");
        else
            outcome->error = jobs[i].error ? strdup(jobs[i].error) : strdup("not run");
        outcome->wall_time_s = jobs[i].wall_time_s;
        free_command(&commands[i]);
    }
    pool_clear(jobs, r->run_count);
    free(jobs);
    free(commands);
    r->wall_time_s = end.wall_time_s;
    return !end.stopped;
}

/* --- writing them down ----------------------------------------------------------------------------------- */

/* Whole or not at all: under another name first. */
static bool write_json(const struct results *r, const char *dir, char **error)
{
    char *path = text_of("%s/tables.json", dir);
    char *draft = text_of("%s/tables.json.%ld", dir, (long)getpid());
    json_t *root = results_json(r);
    bool ok = json_dump_file(root, draft, JSON_INDENT(1) | JSON_REAL_PRECISION(15)) == 0 &&
              rename(draft, path) == 0;
    if (!ok) {
        *error = text_of("%s cannot be written: %s", path, strerror(errno));
        unlink(draft);
    }
    json_decref(root);
    free(path);
    free(draft);
    return ok;
}

/* One picture a table. A picture that fails is said on progress. */
static bool draw(const struct tables_options *o, const struct results *r, const char *scratch)
{
    bool ok = true;
    for (size_t t = 0; t < r->table_count; t++) {
        char *path = text_of("%s/plot", scratch);
        FILE *script = fopen(path, "we");
        if (script) {
            results_plot(&r->tables[t], o->dir, script);
            fclose(script);
        }
        char *const argv[] = {"gnuplot", path, NULL};
        struct pool_job job = {.name = "the picture", .argv = argv};
        if (!script || !pool_run(&job, 1, 1, NULL).all_done) {
            fprintf(o->progress, "no picture of table %u: %s\n", r->tables[t].table->number,
                    job.error ? job.error : "no room for its script");
            ok = false;
        }
        pool_clear(&job, 1);
        unlink(path);
        free(path);
    }
    return ok;
}

static enum tables_end report(const struct tables_options *o, const struct results *r, const char *scratch,
                              char **error)
{
    results_print(r, o->out);
    if (!write_json(r, o->dir, error))
        return TABLES_ERROR;
    bool drawn = draw(o, r, scratch);
    fprintf(o->out, "%s/tables.json has all figures; the pictures are %s/table-N.png and .svg\n", o->dir,
            o->dir);
    return drawn && results_all_errors(r).failed == 0 ? TABLES_DONE : TABLES_INCOMPLETE;
}

/* --- the whole ------------------------------------------------------------------------------------------- */

static enum tables_end make(const struct tables_options *o, struct results *r, char **error)
{
    const char *tmp = getenv("TMPDIR");
    enum tables_end end = TABLES_ERROR;
    char *scratch = text_of("%s/touchstone-tables.XXXXXX", tmp && *tmp ? tmp : "/tmp");
    if (!r->table_count)
        *error = text_of("none of these tables is in paper.cfg");
    else if (!folder_make(o->dir))
        *error = text_of("%s cannot be made: %s", o->dir, strerror(errno));
    else if (!mkdtemp(scratch))
        *error = text_of("%s cannot be made: %s", scratch, strerror(errno));
    else if (!run_all(o, r, scratch))
        *error = text_of("stopped; nothing was written");
    else
        end = report(o, r, scratch, error);
    rmdir(scratch);
    free(scratch);
    return end;
}

enum tables_end tables_make(const struct tables_options *o, char **error)
{
    char *rows_path = text_of("%s/bench/paper/paper.cfg", o->home);
    char *fitted_path = text_of("%s/bench/paper/fitted.cfg", o->home);
    enum tables_end end = TABLES_ERROR;
    struct paper *paper = paper_read(rows_path, error);
    struct paper_fitted *fitted = paper ? paper_read_fitted(fitted_path, error) : NULL;
    if (fitted) {
        struct results r = results_plan(paper, fitted, o->wanted);
        end = make(o, &r, error);
        results_free(&r);
    }
    paper_free_fitted(fitted);
    paper_free(paper);
    free(fitted_path);
    free(rows_path);
    return end;
}
