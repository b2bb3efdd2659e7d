/* fit.c - conducts a fit: the start, which parameters have an influence, the search, what it determines; see fit.h. */
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Parts of a parameter's range: how far one looks for an influence at the start, and how near for slopes at the end. */
static const double FAR = 0.1, NEAR = 0.01;

static double *numbers(size_t count)
{
    double *d = xcalloc(count + 1, sizeof *d);
    return d;
}

static struct fit_problem problem_of(struct fit *f)
{
    return (struct fit_problem){f->count, f->measurements, fit_try, f};
}

/* The places of those searched. */
static void places(const struct fit *f, double x[])
{
    for (size_t i = 0; i < f->count; i++)
        x[i] = f->place[f->searched[i]];
}

/* The figures at the present places. */
static bool measure(struct fit *f, double computed[], double *rms)
{
    double x[FIT_MAX_NUMBERS], *residuals = numbers(f->measurements);
    places(f, x);
    bool good = fit_try(f, x, residuals);
    *rms = fit_rms(residuals, f->measurements);
    memcpy(computed, f->computed, f->measurements * sizeof *computed);
    free(residuals);
    return good;
}

/* Leaves out of the search what has no influence at the start, also far from it. */
static bool leave_out(struct fit *f)
{
    struct fit_problem p = problem_of(f);
    double x[FIT_MAX_NUMBERS], *slope = numbers(p.residuals * p.numbers);
    places(f, x);
    bool good = fit_slopes(&p, x, FAR, slope);
    for (size_t k = f->count = 0; good && k < p.numbers; k++) {
        bool influence = false;
        for (size_t i = 0; i < p.residuals; i++)
            influence |= slope[i * p.numbers + k] != 0;
        if (influence)
            f->searched[f->count++] = k;
    }
    free(slope);
    if (good && !f->count)
        f->error = xasprintf("no parameter has an influence on any measured figure");
    return good && f->count;
}

static bool search(struct fit *f)
{
    struct fit_problem p = problem_of(f);
    double x[FIT_MAX_NUMBERS];
    places(f, x);
    bool good = fit_least(&p, x, f->options->most);
    for (size_t i = 0; i < f->count; i++)
        f->place[f->searched[i]] = x[i];
    return good;
}

/* The parameter's change for one of its place. */
static double stretch(const struct fit_parameter *p, double place)
{
    return p->logarithmic ? fit_value(p, place) * log(p->to / p->from) : p->to - p->from;
}

/* How uncertain residuals are at least: what is behind a measurement's last digit is not known. */
static double rounding(const struct fit *f)
{
    double sum = 0;
    for (size_t i = 0; i < f->measurements; i++)
        sum += pow(f->measurement[i].half / f->measurement[i].scale, 2) / 3;
    return sqrt(sum / (double)f->measurements);
}

static double scatter(const struct fit *f, double rms)
{
    double freedom = (double)f->measurements - (double)f->count;
    return fmax(freedom > 0 ? rms * sqrt((double)f->measurements / freedom) : rms, rounding(f));
}

/* From residuals for a place to percent of the figure for a percent of the parameter. */
static void set_percent(const struct fit *f, struct fit_result *r, const double slope[])
{
    for (size_t i = 0; i < f->measurements; i++)
        for (size_t k = 0; k < f->count; k++) {
            size_t n = f->searched[k];
            double value = fit_value(&f->parameter[n], f->place[n]),
                   per_one = slope[i * f->count + k] * f->measurement[i].scale /
                             stretch(&f->parameter[n], f->place[n]);
            r->percent[i * f->parameters + n] = r->after[i] != 0 ? per_one * value / fabs(r->after[i]) : 0;
        }
}

/* Which are determined, all of them and not only those searched. */
static void set_standings(const struct fit *f, struct fit_result *r, const double slope[])
{
    struct fit_number found[FIT_MAX_NUMBERS];
    fit_determine(slope, f->measurements, f->count, scatter(f, r->rms_after), found);
    for (size_t n = 0; n < f->parameters; n++)
        r->number[n] = (struct fit_number){FIT_NO_INFLUENCE, INFINITY, {0}};
    for (size_t k = 0; k < f->count; k++) {
        struct fit_number *to = &r->number[f->searched[k]];
        to->standing = found[k].standing;
        to->error = found[k].error;
        for (size_t other = 0; other < f->count; other++)
            to->with[f->searched[other]] = found[k].with[other];
    }
}

static bool look_around(struct fit *f, struct fit_result *r)
{
    struct fit_problem p = problem_of(f);
    double x[FIT_MAX_NUMBERS], *slope = numbers(p.residuals * p.numbers);
    places(f, x);
    bool good = fit_slopes(&p, x, NEAR, slope);
    if (good) {
        set_percent(f, r, slope);
        set_standings(f, r, slope);
    }
    for (size_t n = 0; n < f->parameters; n++) {
        fit_text(&f->parameter[n], f->place[n], r->text[n]);
        r->error[n] = r->number[n].error * stretch(&f->parameter[n], f->place[n]);
    }
    free(slope);
    return good;
}

static void begin(struct fit *f, struct fit_result *r)
{
    f->computed = numbers(f->measurements);
    for (size_t n = 0; n < f->parameters; n++) {
        f->searched[f->count++] = n;
        f->place[n] = fit_place(&f->parameter[n], f->parameter[n].start);
        fit_text(&f->parameter[n], f->place[n], r->start[n]);
    }
    r->before = numbers(f->measurements);
    r->after = numbers(f->measurements);
    r->percent = numbers(f->measurements * f->parameters);
}

static bool determined(const struct fit *f, const struct fit_result *r)
{
    for (size_t n = 0; n < f->parameters; n++)
        if (r->number[n].standing != FIT_DETERMINED)
            return false;
    return true;
}

static enum fit_end conduct(struct fit *f, struct fit_result *r, char **error)
{
    begin(f, r);
    bool good = measure(f, r->before, &r->rms_before) && leave_out(f) && search(f) &&
                measure(f, r->after, &r->rms_after) && look_around(f, r);
    if (!good) {
        *error = f->error;
        f->error = NULL;
        return FIT_ERROR;
    }
    fit_print(f, r, f->options->out);
    if (!fit_write(f, r, error))
        return FIT_ERROR;
    return determined(f, r) ? FIT_DONE : FIT_UNDETERMINED;
}

enum fit_end fit_run(const struct fit_options *options, char **error)
{
    struct fit f = {.options = options};
    struct fit_result r = {0};
    enum fit_end end = fit_read(&f, error) ? conduct(&f, &r, error) : FIT_ERROR;
    free(r.before);
    free(r.after);
    free(r.percent);
    fit_clear(&f);
    return end;
}
