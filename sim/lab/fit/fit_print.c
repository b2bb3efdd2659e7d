/* fit_print.c - the result of a fit as text for people; see fit_parts.h. */
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"
#include "files/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *unit(const struct fit *f)
{
    return f->by_rounding ? "half units of the last digit" : "percent";
}

/* The names of the other parameters of its combination, with commas; malloc'd. */
static char *names_with(const struct fit *f, const struct fit_number *n)
{
    char *names = xstrdup("");
    for (size_t i = 0; i < f->parameters; i++)
        if (n->with[i])
            words_append(&names, "%s%s", *names ? ", " : "", f->parameter[i].name);
    return names;
}

char *fit_note(const struct fit *f, const struct fit_result *r, size_t i)
{
    const struct fit_number *n = &r->number[i];
    if (n->standing == FIT_NO_INFLUENCE)
        return xasprintf("not determined: no measured figure changes with it");
    if (n->standing == FIT_OPEN)
        return xasprintf("not determined: the measurements leave it open");
    if (n->standing == FIT_COMBINED) {
        char *names = names_with(f, n), *said = xasprintf("not determined: only together with %s", names);
        free(names);
        return said;
    }
    bool end = f->position[i] < 1e-4 || f->position[i] > 1 - 1e-4;
    return xstrdup(end ? "at the end of its range" : "");
}

static void print_parameters(const struct fit *f, const struct fit_result *r, FILE *out)
{
    fprintf(out, "%-24s %12s %12s %12s %12s %12s\n", "parameter", "from", "to", "start", "fitted",
            "std error");
    for (size_t i = 0; i < f->parameters; i++) {
        const struct fit_parameter *p = &f->parameter[i];
        char *said = fit_note(f, r, i);
        fprintf(out, "%-24s %12.6g %12.6g %12s %12s ", p->name, p->from, p->to, r->start[i], r->text[i]);
        if (isfinite(r->error[i]))
            fprintf(out, "%12.2g", r->error[i]);
        else
            fprintf(out, "%12s", "any");
        fprintf(out, "%s%s\n", *said ? "  " : "", said);
        free(said);
    }
}

/* With so many decimals the largest value of the measurement's figure has six digits. */
static int decimals_of(const struct fit *f, const struct fit_result *r, size_t of)
{
    double most = 0;
    for (size_t i = 0; i < f->measurements; i++)
        if (!strcmp(f->measurement[i].figure, f->measurement[of].figure))
            most = fmax(most, fmax(fabs(r->before[i]), fabs(r->after[i])));
    return most > 0 && most < 1e5 ? 5 - (int)floor(log10(most)) : 0;
}

/* The decimals that a measurement was given with, at most so many. */
static int decimals_given(const struct fit_measurement *m, int most)
{
    return (int)fmin(most, fmax(0, -round(log10(2 * m->half))));
}

static void print_measurements(const struct fit *f, const struct fit_result *r, FILE *out)
{
    fprintf(out, "\n%-40s %14s %14s %14s %9s\n", "measurement", "measured", "at the start", "fitted",
            "error");
    for (size_t i = 0; i < f->measurements; i++) {
        const struct fit_measurement *m = &f->measurement[i];
        int decimals = decimals_of(f, r, i);
        fprintf(out, "%-40s %14.*f %14.*f %14.*f ", m->name, decimals_given(m, decimals), m->value, decimals,
                r->before[i], decimals, r->after[i]);
        if (m->value != 0)
            fprintf(out, "%+8.3f%%\n", 100 * (r->after[i] - m->value) / fabs(m->value));
        else
            fprintf(out, "%+9.3g\n", r->after[i]);
    }
}

static void print_sensitivities(const struct fit *f, const struct fit_result *r, FILE *out)
{
    fputs("\nsensitivity: percent of the figure for one percent of the parameter\n", out);
    fprintf(out, "%-40s", "");
    for (size_t n = 0; n < f->parameters; n++)
        fprintf(out, " %14s", f->parameter[n].name);
    for (size_t i = 0; i < f->measurements; i++) {
        fprintf(out, "\n%-40s", f->measurement[i].name);
        for (size_t n = 0; n < f->parameters; n++) {
            double percent = r->percent[i * f->parameters + n];
            if (isnan(percent))
                fprintf(out, " %14s", "not known");
            else
                fprintf(out, " %+14.6f", percent);
        }
    }
    fputc('\n', out);
}

static void print_failed(const struct fit *f, FILE *out)
{
    if (f->failed)
        fputs("\nruns that failed; the fit leaves them out\n", out);
    for (char **run = f->failed; run && *run; run++)
        fprintf(out, "%s\n", *run);
}

void fit_print(const struct fit *f, const struct fit_result *r, FILE *out)
{
    print_parameters(f, r, out);
    print_measurements(f, r, out);
    print_sensitivities(f, r, out);
    print_failed(f, out);
    fprintf(out, "\nroot mean square of the residuals, %s: %.4g at the start, %.4g fitted\n", unit(f),
            r->rms_before, r->rms_after);
    fprintf(out, "%s: %u evaluations, %zu runs, %zu results of earlier runs\n", fit_least_method(f->count),
            f->evaluations, f->counts.run, f->counts.before + f->counts.cached);
    fprintf(out, "%s has the constants\n", f->options->constants);
}
