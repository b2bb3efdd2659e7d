/* study.c - opens a study: reads its file, checks all its points, opens its folder; see study.h. */
#include "files/program_file.h"
#include "files/folder_make.h"
#include "kernel/xalloc.h"
#include "lab/jobs/scratch_memory.h"
#include "lab/study/spec_read.h"
#include "lab/study/study_parts.h"

#include <libgen.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* --- the points ----------------------------------------------------------------------------------------- */

static int by_number(const void *a, const void *b)
{
    const struct work *x = a, *y = b;
    return x->number < y->number ? -1 : x->number > y->number;
}

static int dearest_first(const void *a, const void *b)
{
    const struct work *x = a, *y = b;
    if (x->cost != y->cost)
        return x->cost < y->cost ? 1 : -1;
    return by_number(a, b);
}

void study_sort(struct study *s, bool by_cost)
{
    qsort(s->work, s->count, sizeof *s->work, by_cost ? dearest_first : by_number);
}

/* The point's cost as the study file gives it, or else its number of nodes. */
static double cost_of(const struct spec *s, const struct point *p)
{
    double cost = s->cost ? expr_number(s->cost, p->value) : (double)point_nodes(s, p);
    return cost > 0 && isfinite(cost) ? cost : 1;
}

/* Makes and checks all points, before any is run. */
static bool plan(struct study *s, char **error)
{
    struct point p;
    s->work = scratch_memory_new(s->spec->product * sizeof *s->work);
    for (size_t number = 0; number < s->spec->product; number++) {
        enum point_is is = point_make(s->spec, number, &p, error);
        struct work *w = &s->work[s->count];
        if (is == POINT_WRONG)
            return false;
        if (is == POINT_LEFT_OUT)
            continue;
        if (!inputs_of(s->inputs, &p, &w->key, NULL, error))
            return false;
        w->number = number;
        w->cost = cost_of(s->spec, &p);
        s->count++;
    }
    if (!s->count)
        *error = xasprintf("%s: only: no point is left", s->options.file);
    return s->count;
}

/* --- the rest ------------------------------------------------------------------------------------------- */

/* Sets s->dir to the study file's folder: paths in the file are relative to it, and runs work in it. */
static bool find_dir(struct study *s, char **error)
{
    char *file = xstrdup(s->options.file), real[PATH_MAX];
    bool found = realpath(dirname(file), real);
    if (found)
        s->dir = xstrdup(real);
    else
        *error = xasprintf("%s: %m", s->options.file);
    free(file);
    return found;
}

const char *study_program(const struct study *s)
{
    return s->program;
}

/* Finds the study's program: beside the study file, or among those that come with touchstone. */
static bool find_program(struct study *s, char **error)
{
    const char *name = s->options.program ? s->options.program : s->spec->program;
    char *why = NULL;
    s->program = program_file_find(name, s->dir, s->options.programs, &why);
    if (!s->program)
        *error = xasprintf(
            "%s:%u: program: %s", s->options.file,
            (unsigned)config_setting_source_line(config_setting_get_member(s->spec->reader.root, "program")),
            why);
    free(why);
    return s->program;
}

static bool read_inputs(struct study *s, char **error)
{
    struct inputs_paths paths = {s->options.runner, s->program,          s->options.machines, s->dir,
                                 s->options.set,    s->options.arguments};
    return (s->inputs = inputs_open(s->spec, &paths, error));
}

static bool open_folder(struct study *s, char **error)
{
    const struct study_options *o = &s->options;
    if (!folder_make(o->dir)) {
        *error = xasprintf("%s cannot be made: %m", o->dir);
        return false;
    }
    if (!(s->locks = point_locks_enter(o->dir, o->session, error)) ||
        !(s->journal = journal_open(o->dir, o->progress, error)) ||
        !(s->scratch = folder_scratch("touchstone-study", error)).path)
        return false;
    if (o->retry_failed)
        journal_forget_failed(s->journal);
    return true;
}

struct study *study_open(const struct study_options *options, char **error)
{
    struct study *s = xcalloc(1, sizeof *s);
    s->options = *options;
    if (!s->options.session)
        s->options.session = "";
    if ((s->spec = spec_read(options->file, error)) && find_dir(s, error) && find_program(s, error) &&
        read_inputs(s, error) && plan(s, error) && open_folder(s, error))
        return s;
    study_close(s);
    return NULL;
}

void study_close(struct study *s)
{
    if (!s)
        return;
    journal_close(s->journal);
    point_locks_leave(s->locks);
    scratch_remove(&s->scratch);
    if (s->work)
        scratch_memory_free(s->work, s->spec->product * sizeof *s->work);
    inputs_close(s->inputs);
    speedup_free(s->speedup);
    free(s->program);
    free(s->dir);
    spec_free(s->spec);
    free(s);
}

struct study_counts study_counts(const struct study *s)
{
    return s->counts;
}
