/* fit_least.h - least squares: the numbers that make residuals least, and the residuals' slopes. Knows
 * nothing of studies.
 *
 * All numbers are between 0 and 1, the ends of their ranges. Residuals have no unit: each is relative to its
 * uncertainty. The search makes their root mean square least. It needs no derivatives, so that residuals need
 * not be smooth: BOBYQA (M. J. D. Powell, University of Cambridge, report DAMTP 2009/NA06), or Nelder and
 * Mead's simplex for a single number.
 */
#ifndef LAB_FIT_FIT_LEAST_H
#define LAB_FIT_FIT_LEAST_H
#include <stdbool.h>
#include <stddef.h>

enum { FIT_MAX_NUMBERS = 16 };

struct fit_problem {
    size_t numbers;   /* 1 to FIT_MAX_NUMBERS */
    size_t residuals; /* 1 or more */
    /* Computes the residuals at x. False ends the search. */
    bool (*at)(void *arg, const double x[], double residuals[]);
    void *arg;
};

/* Searches from x, in at most `most` evaluations, and sets x to the best. False if at() returned false. */
bool fit_least(const struct fit_problem *p, double x[], unsigned most);
const char *fit_least_method(size_t numbers);

/* slope[i * numbers + k] = d residual i / d number k at x, from residuals `step` below and above x, on one
 * side at an end of the range. False if at() returned false. */
bool fit_slopes(const struct fit_problem *p, const double x[], double step, double slope[]);

double fit_rms(const double residuals[], size_t count);
#endif
