/* fit_try.c - one evaluation of a fit: the study with certain values of the parameters, beside the measurements. What was
 * run before is in the study's journal and in the cache, so that a fit that is begun again comes to where it was. */
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"
#include "lab/jobs/outcome.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is looked for when a run fails is not near: as if it were so many times too long. */
static const double FAILED = 10;

double fit_value(const struct fit_parameter *p, double place)
{
    return p->logarithmic ? p->from * pow(p->to / p->from, place) : p->from + place * (p->to - p->from);
}

double fit_place(const struct fit_parameter *p, double value)
{
    return p->logarithmic ? log(value / p->from) / log(p->to / p->from)
                          : (value - p->from) / (p->to - p->from);
}

void fit_text(const struct fit_parameter *p, double place, char text[32])
{
    snprintf(text, 32, "%.6g", fit_value(p, place));
}

static double residual_of(const struct fit_measurement *m, double computed)
{
    return (computed - m->value) / m->scale;
}

/* --- a point beside the measurements --------------------------------------------------------------------- */

struct visit {
    struct fit *fit;
    unsigned *seen; /* how often each measurement's point came */
};

static bool is_value(const json_t *value, const char *text)
{
    char *end;
    if (json_is_string(value))
        return strcmp(json_string_value(value), text) == 0;
    double number = strtod(text, &end);
    return end != text && !*end && number == json_number_value(value);
}

static bool is_at(const struct fit_measurement *m, const json_t *point)
{
    const char *axis;
    json_t *text;
    json_object_foreach(m->where, axis, text) if (!is_value(json_object_get(point, axis),
                                                            json_string_value(text))) return false;
    return true;
}

/* The first evaluation must have every figure; later ones may fail. */
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
        if (!f->evaluations) {
            *error =
                failure ? xasprintf("%s: %s failed: %s", m->at, m->name, failure)
                        : xasprintf("%s: %s: the run has no such figure, or it is no number", m->at, m->name);
            return false;
        }
        f->computed[i] = m->value * (1 + FAILED);
    }
    return true;
}

static bool compare(struct fit *f, struct study *s)
{
    struct visit v = {f, xcalloc(f->measurements, sizeof *v.seen)};
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

/* --- an evaluation --------------------------------------------------------------------------------------- */

/* What the parameters say, as settings of the machine and words for the program. */
struct said {
    char *set[FIT_MAX_NUMBERS + 1], *text[FIT_MAX_NUMBERS + 1];
    const char **words; /* ended by NULL; they lie in text */
    size_t sets, texts, count;
};

static void say(struct said *s, const struct fit *f, const double place[])
{
    *s = (struct said){.words = xcalloc(1, sizeof *s->words)};
    for (size_t i = 0; i < f->parameters; i++) {
        char value[32], *save;
        fit_text(&f->parameter[i], place[i], value);
        if (f->parameter[i].set)
            s->set[s->sets++] = fit_filled(f->parameter[i].set, "{}", value);
        if (!f->parameter[i].arguments)
            continue;
        char *text = s->text[s->texts++] = fit_filled(f->parameter[i].arguments, "{}", value);
        for (char *word = strtok_r(text, " ", &save); word; word = strtok_r(NULL, " ", &save)) {
            s->words = xrealloc(s->words, (s->count + 2) * sizeof *s->words);
            s->words[s->count++] = word;
            s->words[s->count] = NULL;
        }
    }
}

static void forget(struct said *s)
{
    for (size_t i = 0; i < s->sets; i++)
        free(s->set[i]);
    for (size_t i = 0; i < s->texts; i++)
        free(s->text[i]);
    free(s->words);
}

static bool run(struct fit *f, const double place[])
{
    struct study_options o = f->options->study;
    struct said s;
    if (!fit_build(f, place))
        return false;
    say(&s, f, place);
    o.program = f->program;
    o.set = (const char *const *)s.set;
    o.arguments = s.words;
    struct study *study = study_open(&o, &f->error);
    enum study_end end = study ? study_run(study, &f->error) : STUDY_ERROR;
    if (end == STUDY_STOPPED)
        f->error = xasprintf("stopped by a signal; the same command goes on from here");
    bool good = (end == STUDY_DONE || end == STUDY_INCOMPLETE) && compare(f, study);
    if (good) {
        struct study_counts c = study_counts(study);
        f->counts.run += c.run;
        f->counts.before += c.before;
        f->counts.cached += c.cached;
    }
    study_close(study);
    forget(&s);
    return good;
}

static void tell(const struct fit *f, const double place[], double rms)
{
    FILE *to = f->options->progress;
    fprintf(to, "%3u  %s %.6g", f->evaluations, f->by_rounding ? "rms" : "rms, percent", rms);
    for (size_t i = 0; i < f->parameters; i++) {
        char text[32];
        fit_text(&f->parameter[i], place[i], text);
        fprintf(to, "  %s %s", f->parameter[i].name, text);
    }
    fputc('\n', to);
}

bool fit_try(void *arg, const double x[], double residuals[])
{
    struct fit *f = arg;
    double place[FIT_MAX_NUMBERS];
    memcpy(place, f->place, sizeof place);
    for (size_t i = 0; i < f->count; i++)
        place[f->searched[i]] = x[i];
    if (!run(f, place))
        return false;
    for (size_t i = 0; i < f->measurements; i++)
        residuals[i] = residual_of(&f->measurement[i], f->computed[i]);
    f->evaluations++;
    tell(f, place, fit_rms(residuals, f->measurements));
    return true;
}
