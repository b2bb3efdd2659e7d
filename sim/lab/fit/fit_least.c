/* fit_least.c - see fit_least.h. */
#include "lab/fit/fit_least.h"
#include "kernel/xalloc.h"

#include <math.h>
#include <nlopt.h>
#include <stdlib.h>
#include <string.h>

/* The search's first and last steps, as parts of the range. */
static const double FIRST_STEP = 0.1, LAST_STEP = 1e-5;

struct search {
    const struct fit_problem *problem;
    nlopt_opt opt;
    double *residuals, *best, best_rms, worst_rms;
    bool failed;
};

static double *numbers(size_t count)
{
    double *d = xcalloc(count + 1, sizeof *d);
    return d;
}

double fit_rms(const double residuals[], size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += residuals[i] * residuals[i];
    return sqrt(sum / (double)count);
}

/* The objective for NLopt. Remembers the best x, for a search that is stopped. Where a run failed, the search
 * is told the worst of what ran: that leads it away, and bends BOBYQA's parabola less than more would. */
static double squares(unsigned n, const double x[], double gradient[], void *arg)
{
    struct search *s = arg;
    (void)gradient;
    if (s->failed || !s->problem->at(s->problem->arg, x, s->residuals)) {
        s->failed = true;
        nlopt_force_stop(s->opt);
        return INFINITY;
    }
    double rms = fit_rms(s->residuals, s->problem->residuals);
    if (isnan(rms))
        return s->worst_rms * s->worst_rms;
    if (rms < s->best_rms) {
        s->best_rms = rms;
        memcpy(s->best, x, n * sizeof *x);
    }
    s->worst_rms = fmax(s->worst_rms, rms);
    return rms * rms;
}

static nlopt_algorithm algorithm(size_t n)
{
    return n > 1 ? NLOPT_LN_BOBYQA : NLOPT_LN_NELDERMEAD;
}

const char *fit_least_method(size_t n)
{
    return n > 1 ? "least squares by BOBYQA (NLopt)" : "least squares by Nelder and Mead's simplex (NLopt)";
}

bool fit_least(const struct fit_problem *p, double x[], unsigned most)
{
    unsigned n = (unsigned)p->numbers;
    struct search s = {.problem = p,
                       .opt = xchecked(nlopt_create(algorithm(n), n)),
                       .residuals = numbers(p->residuals),
                       .best = numbers(n),
                       .best_rms = INFINITY};
    double least, *from = numbers(n);
    memcpy(s.best, x, n * sizeof *x);
    memcpy(from, x, n * sizeof *x);
    nlopt_set_lower_bounds1(s.opt, 0);
    nlopt_set_upper_bounds1(s.opt, 1);
    nlopt_set_initial_step1(s.opt, FIRST_STEP);
    nlopt_set_xtol_abs1(s.opt, LAST_STEP);
    nlopt_set_maxeval(s.opt, (int)most);
    nlopt_set_min_objective(s.opt, squares, &s);
    nlopt_optimize(s.opt, from, &least);
    memcpy(x, s.best, n * sizeof *x);
    nlopt_destroy(s.opt);
    free(s.residuals);
    free(s.best);
    free(from);
    return !s.failed;
}

/* The slope of one residual, between the outermost positions at which it is there. */
static double slope_of(const double x[3], const double residual[3])
{
    int low = isnan(residual[0]) ? 1 : 0, high = isnan(residual[2]) ? 1 : 2;
    return x[high] > x[low] ? (residual[high] - residual[low]) / (x[high] - x[low]) : NAN;
}

/* The slopes of all residuals by number k. */
static bool slopes_of(const struct fit_problem *p, double x[], const double here[], size_t k, double step,
                      double slope[], double *below, double *above)
{
    double by[] = {fmax(x[k] - step, 0), x[k], fmin(x[k] + step, 1)};
    x[k] = by[0];
    bool good = p->at(p->arg, x, below);
    x[k] = by[2];
    good = good && p->at(p->arg, x, above);
    x[k] = by[1];
    for (size_t i = 0; good && i < p->residuals; i++)
        slope[i * p->numbers + k] = slope_of(by, (double[]){below[i], here[i], above[i]});
    return good;
}

bool fit_slopes(const struct fit_problem *p, const double x[], const double here[], double step,
                double slope[])
{
    double *at = numbers(p->numbers), *below = numbers(p->residuals), *above = numbers(p->residuals);
    bool good = true;
    memcpy(at, x, p->numbers * sizeof *x);
    for (size_t k = 0; good && k < p->numbers; k++)
        good = slopes_of(p, at, here, k, step, slope, below, above);
    free(at);
    free(below);
    free(above);
    return good;
}
