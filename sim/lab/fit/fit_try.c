/* fit_try.c - one evaluation of a fit: runs the study with certain values of the parameters and compares it
 * with the measurements. A fit that was interrupted repeats its evaluations quickly: their points are in the
 * study's journal and in the result cache. */
#include "files/json_set.h"
#include "files/number.h"
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"
#include "lab/jobs/outcome.h"
#include "files/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double residual_of(const struct fit_measurement *m, double computed)
{
    return (computed - m->value) / m->scale;
}

/* --- comparing a point with the measurements ------------------------------------------------------------ */

struct visit {
    struct fit *fit;
    const char *at; /* the parameters' values */
    unsigned *seen; /* for each measurement, the number of points that match it */
};

static bool is_value(const json_t *value, const char *text)
{
    double number;
    if (json_is_string(value))
        return strcmp(json_string_value(value), text) == 0;
    return number_read(text, &number, NULL) && number == json_number_value(value);
}

static bool is_at(const struct fit_measurement *m, const json_t *point)
{
    const char *axis;
    json_t *text;
    json_object_foreach(m->where, axis, text) if (!is_value(json_object_get(point, axis),
                                                            json_string_value(text))) return false;
    return true;
}

/* Adds a run to those that failed, unless it is among them. */
static void add_failed(struct fit *f, const char *at, const char *name, const char *reason)
{
    char *said = xasprintf("%s: %s: %s", at, name, reason);
    for (char **other = f->failed; other && *other; other++)
        if (strcmp(*other, said) == 0) {
            free(said);
            return;
        }
    words_add(&f->failed, said);
}

/* Takes the figures of a point. In the first evaluation every figure must be there; later runs may fail. */
static bool visit_point(void *arg, const json_t *point, char **error)
{
    struct visit *v = arg;
    struct fit *f = v->fit;
    const char *failure = json_string_value(json_object_get(point, "failure"));
    for (size_t i = 0; i < f->measurements; i++) {
        struct fit_measurement *m = &f->measurement[i];
        if (!is_at(m, point))
            continue;
        v->seen[i]++;
        f->computed[i] = figure_of(point, m->figure);
        if (!isnan(f->computed[i]))
            continue;
        const char *reason = failure ? failure : "the run has no such figure, or it is no number";
        if (!f->evaluations) {
            char *names = failure ? xstrdup("") : json_keys_text(point, NULL);
            *error = xasprintf("%s: %s%s: %s%s%s", m->at, m->name, failure ? " failed" : "", reason,
                               failure ? "" : "; it has: ", names);
            free(names);
            return false;
        }
        add_failed(f, v->at, m->name, reason);
    }
    return true;
}

static bool compare(struct fit *f, struct study *s, const char *at)
{
    struct visit v = {f, at, xcalloc(f->measurements, sizeof *v.seen)};
    bool good = study_each(s, visit_point, &v, &f->error);
    for (size_t i = 0; good && i < f->measurements; i++)
        if (v.seen[i] != 1) {
            f->error = xasprintf("%s: %s is %s", f->measurement[i].at, f->measurement[i].name,
                                 v.seen[i] ? "several points of the study" : "no point of the study");
            good = false;
        }
    free(v.seen);
    return good;
}

/* --- an evaluation -------------------------------------------------------------------------------------- */

/* The parameters' values as settings of the machine and arguments of the program. */
struct given {
    char **set, **arguments;
};

static struct given give(const struct fit *f, const double position[])
{
    struct given g = {0};
    for (size_t i = 0; i < f->parameters; i++) {
        const struct fit_parameter *p = &f->parameter[i];
        char value[32];
        fit_text(p, position[i], value);
        if (p->set)
            words_add(&g.set, words_filled(p->set, "{}", value));
        if (p->arguments)
            words_add_all(&g.arguments, words_filled(p->arguments, "{}", value));
    }
    return g;
}

/* No machine, or no study, can have these values: as if all runs had failed. In the first evaluation that is
 * an error. */
static bool is_impossible(struct fit *f, const char *at)
{
    if (!f->evaluations)
        return false;
    add_failed(f, at, "no run", f->error);
    free(f->error);
    f->error = NULL;
    for (size_t i = 0; i < f->measurements; i++)
        f->computed[i] = NAN;
    return true;
}

static bool run(struct fit *f, const double position[], const char *at)
{
    struct study_options o = f->options->study;
    if (!fit_build(f, position))
        return false;
    struct given g = give(f, position);
    o.program = f->program;
    o.set = (const char *const *)g.set;
    o.arguments = (const char *const *)g.arguments;
    struct study *study = study_open(&o, &f->error);
    bool impossible = !study && is_impossible(f, at);
    enum study_end end = study ? study_run(study, &f->error) : STUDY_ERROR;
    if (end == STUDY_STOPPED)
        *f->options->signal = study_counts(study).signal,
        f->error = xasprintf("stopped by a signal; the same command goes on from here");
    bool good = (end == STUDY_DONE || end == STUDY_INCOMPLETE) && compare(f, study, at);
    if (good) {
        struct study_counts c = study_counts(study);
        f->counts.run += c.run;
        f->counts.before += c.before;
        f->counts.cached += c.cached;
    }
    study_close(study);
    words_free(g.set);
    words_free(g.arguments);
    return good || impossible;
}

/* "send 40.0000  interrupt 89.4427": the numbers that fit_text gives, with noughts; malloc'd. */
static char *values_at(const struct fit *f, const double position[])
{
    char *values = xstrdup("");
    for (size_t i = 0; i < f->parameters; i++) {
        words_append(&values, "%s%s %#.6g", i ? "  " : "", f->parameter[i].name,
                     fit_value(&f->parameter[i], position[i]));
    }
    return values;
}

static void tell(const struct fit *f, const char *at, double rms)
{
    FILE *to = f->options->progress;
    fprintf(to, "%3u  ", f->evaluations);
    if (isnan(rms))
        fputs("a run failed", to);
    else
        fprintf(to, "%s %9.4f", f->by_rounding ? "rms" : "rms, percent", rms);
    fprintf(to, "  %s\n", at);
}

bool fit_try(void *arg, const double x[], double residuals[])
{
    struct fit *f = arg;
    double position[FIT_MAX_NUMBERS];
    memcpy(position, f->position, sizeof position);
    for (size_t i = 0; i < f->count; i++)
        position[f->searched[i]] = x[i];
    char *at = values_at(f, position);
    bool good = run(f, position, at);
    if (good) {
        for (size_t i = 0; i < f->measurements; i++)
            residuals[i] = residual_of(&f->measurement[i], f->computed[i]);
        f->evaluations++;
        tell(f, at, fit_rms(residuals, f->measurements));
    }
    free(at);
    return good;
}
