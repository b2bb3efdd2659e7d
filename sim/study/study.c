/* study.c - from a study file to points, through the pool, to results; see study.h. */
#include "study/study.h"
#include "study/chart.h"
#include "study/draft.h"
#include "study/figures.h"
#include "study/folder.h"
#include "study/pool.h"
#include "study/progress.h"
#include "study/record.h"
#include "study/text.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What the point came to, from its job; takes the job's error over. */
static void settle(struct point *p, struct pool_job *job, size_t number, const char *scratch)
{
    p->wall_time_s = job->wall_time_s;
    if (job->state != POOL_DONE) {
        p->failure = text_of("%s", job->error ? job->error : "not run");
        return;
    }
    char *json = text_of("%s/%zu.json", scratch, number);
    struct outcome o = outcome_read(job->out, json, NULL);
    if (o.error)
        p->failure = text_of("%s", o.error);
    else
        p->figures = figures_of(&o);
    outcome_clear(&o);
    free(json);
}

/* Runs all; false when a signal stopped it. */
static bool run_all(const struct study_options *o, struct points *p, const char *scratch)
{
    struct pool_job *jobs = calloc(p->count, sizeof *jobs);
    if (!jobs)
        abort();
    for (size_t i = 0; i < p->count; i++) {
        const struct spec_axis *nodes = spec_axis(p->spec, "nodes");
        double weight = nodes ? nodes->values[p->point[i].at[spec_place(p->spec, nodes)]].number : 1;
        jobs[i] = (struct pool_job){.name = p->point[i].name, .argv = p->point[i].argv, .weight = weight};
    }
    struct progress progress;
    struct pool_watcher watcher = progress_watcher(&progress, o->progress);
    struct pool_end end = pool_run(jobs, p->count, o->at_once, &watcher);
    progress_end(&progress);
    for (size_t i = 0; i < p->count; i++)
        settle(&p->point[i], &jobs[i], i, scratch);
    pool_clear(jobs, p->count);
    free(jobs);
    return !end.stopped;
}

static bool write_json(const struct points *p, const char *dir, char **error)
{
    struct draft d;
    if (!draft_begin(&d, dir, "results.json", error))
        return false;
    json_t *root = record_json(p);
    json_dumpf(root, d.out, JSON_INDENT(1) | JSON_REAL_PRECISION(15));
    fputc('\n', d.out);
    json_decref(root);
    return draft_end(&d, error);
}

static bool write_csv(const struct points *p, const char *dir, char **error)
{
    struct draft d;
    if (!draft_begin(&d, dir, "results.csv", error))
        return false;
    record_csv(p, d.out);
    return draft_end(&d, error);
}

/* A picture that fails is said on progress. */
static bool draw(const struct study_options *o, const struct points *p, const struct spec_picture *picture,
                 const char *scratch)
{
    char *path = text_of("%s/plot", scratch);
    FILE *script = fopen(path, "we");
    bool written = script && chart_write(p, picture, o->dir, script);
    if (script)
        fclose(script);
    char *const argv[] = {"gnuplot", path, NULL};
    struct pool_job job = {.name = "the picture", .argv = argv};
    bool drawn = written && pool_run(&job, 1, 1, NULL).all_done;
    if (!drawn)
        fprintf(o->progress, "no picture %s: %s\n", picture->file,
                job.error ? job.error
                : written ? "gnuplot was stopped"
                          : "no point has its figure");
    pool_clear(&job, 1);
    free(path);
    return drawn;
}

static enum study_end report(const struct study_options *o, const struct points *p, const char *scratch,
                             char **error)
{
    size_t failed = 0, drawn = 0;
    if (!write_json(p, o->dir, error) || !write_csv(p, o->dir, error))
        return STUDY_ERROR;
    for (size_t i = 0; i < p->count; i++)
        failed += p->point[i].failure != NULL;
    for (size_t i = 0; i < p->spec->picture_count; i++)
        drawn += draw(o, p, &p->spec->pictures[i], scratch);
    fprintf(o->out, "%zu points, %zu failed; %s has results.json, results.csv and %zu picture%s\n", p->count,
            failed, o->dir, drawn, drawn == 1 ? "" : "s");
    return failed || drawn < p->spec->picture_count ? STUDY_INCOMPLETE : STUDY_DONE;
}

/* The study's program: beside its file, or among those that come with touchstone. NULL with *error. */
static char *find_program(const struct study_options *o, const struct spec *s, char **error)
{
    const char *slash = strrchr(o->file, '/');
    char *beside = *s->program == '/' ? text_of("%s", s->program)
                   : slash            ? text_of("%.*s/%s", (int)(slash - o->file), o->file, s->program)
                                      : text_of("./%s", s->program);
    char *ours = text_of("%s/%s", o->programs, s->program), *path = NULL;
    if (access(beside, X_OK) == 0)
        path = text_of("%s", beside);
    else if (access(ours, X_OK) == 0)
        path = text_of("%s", ours);
    else
        *error = text_of("%s: program: there is neither %s nor %s", o->file, beside, ours);
    free(beside);
    free(ours);
    return path;
}

static enum study_end make(const struct study_options *o, const struct spec *s, const char *program,
                           char **error)
{
    char *scratch = folder_scratch("touchstone-study", error);
    if (!scratch)
        return STUDY_ERROR;
    enum study_end end = STUDY_ERROR;
    struct points_places places = {o->runner, program, scratch};
    struct points points = points_plan(s, &places);
    if (!points.count)
        *error = text_of("%s: only: no point is left", o->file);
    else if (!folder_make(o->dir))
        *error = text_of("%s cannot be made: %m", o->dir);
    else if (!run_all(o, &points, scratch))
        *error = text_of("stopped; nothing was written");
    else
        end = report(o, &points, scratch, error);
    points_free(&points);
    folder_remove(scratch);
    free(scratch);
    return end;
}

enum study_end study_make(const struct study_options *o, char **error)
{
    struct spec *s = spec_read(o->file, error);
    char *program = s ? find_program(o, s, error) : NULL;
    enum study_end end = program ? make(o, s, program, error) : STUDY_ERROR;
    free(program);
    spec_free(s);
    return end;
}
