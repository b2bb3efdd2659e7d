/* fit.c - conducts a fit: which parameters have an influence, the search, what the data determine; see
 * fit.h. */
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Steps as parts of a parameter's range: FAR to look for an influence at the start, NEAR for slopes at the
 * end. */
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

/* Sets x to the positions of the parameters that are searched. */
static void positions(const struct fit *f, double x[])
{
    for (size_t i = 0; i < f->count; i++)
        x[i] = f->position[f->searched[i]];
}

/* Computes the figures and r->residuals at the present positions. */
static bool measure(struct fit *f, struct fit_result *r, double computed[], double *rms)
{
    double x[FIT_MAX_NUMBERS];
    positions(f, x);
    bool good = fit_try(f, x, r->residuals);
    *rms = fit_rms(r->residuals, f->measurements);
    memcpy(computed, f->computed, f->measurements * sizeof *computed);
    return good;
}

/* Leaves parameters out of the search that have no influence at the start, nor a step FAR from it. */
static bool leave_out(struct fit *f, const struct fit_result *r)
{
    struct fit_problem p = problem_of(f);
    double x[FIT_MAX_NUMBERS], *slope = numbers(p.residuals * p.numbers);
    positions(f, x);
    bool good = fit_slopes(&p, x, r->residuals, FAR, slope);
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
    positions(f, x);
    bool good = fit_least(&p, x, f->options->most);
    for (size_t i = 0; i < f->count; i++)
        f->position[f->searched[i]] = x[i];
    return good;
}

/* The derivative of the parameter's value by its position. */
static double slope_of_value(const struct fit_parameter *p, double position)
{
    return p->logarithmic ? fit_value(p, position) * log(p->to / p->from) : p->to - p->from;
}

/* The least scatter of the residuals: measurements are rounded to their last digit. */
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

/* Turns slopes, residuals by position, into percent of the figure for one percent of the parameter. */
static void set_percent(const struct fit *f, struct fit_result *r, const double slope[])
{
    for (size_t i = 0; i < f->measurements; i++)
        for (size_t k = 0; k < f->count; k++) {
            size_t n = f->searched[k];
            double value = fit_value(&f->parameter[n], f->position[n]),
                   per_one = slope[i * f->count + k] * f->measurement[i].scale /
                             slope_of_value(&f->parameter[n], f->position[n]);
            r->percent[i * f->parameters + n] = r->after[i] != 0 ? per_one * value / fabs(r->after[i]) : 0;
        }
}

/* Sets the standing of every parameter, of those left out of the search, too. */
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
    positions(f, x);
    bool good = fit_slopes(&p, x, r->residuals, NEAR, slope);
    if (good) {
        set_percent(f, r, slope);
        set_standings(f, r, slope);
    }
    for (size_t n = 0; n < f->parameters; n++) {
        fit_text(&f->parameter[n], f->position[n], r->text[n]);
        r->error[n] = r->number[n].error * slope_of_value(&f->parameter[n], f->position[n]);
    }
    free(slope);
    return good;
}

static void begin(struct fit *f, struct fit_result *r)
{
    f->computed = numbers(f->measurements);
    for (size_t n = 0; n < f->parameters; n++) {
        f->searched[f->count++] = n;
        f->position[n] = fit_position(&f->parameter[n], f->parameter[n].start);
        fit_text(&f->parameter[n], f->position[n], r->start[n]);
    }
    r->before = numbers(f->measurements);
    r->after = numbers(f->measurements);
    r->residuals = numbers(f->measurements);
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
    bool good = measure(f, r, r->before, &r->rms_before) && leave_out(f, r) && search(f) &&
                measure(f, r, r->after, &r->rms_after) && look_around(f, r);
    if (!good) {
        *error = f->error;
        f->error = NULL;
        return FIT_ERROR;
    }
    fit_print(f, r, f->options->out);
    if (!fit_write(f, r, error) || !fit_write_json(f, r, error))
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
    free(r.residuals);
    free(r.percent);
    fit_clear(&f);
    return end;
}
