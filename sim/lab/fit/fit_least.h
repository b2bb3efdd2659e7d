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
    /* Computes the residuals at x; NAN: there is none, because its run failed. False ends the search. */
    bool (*at)(void *arg, const double x[], double residuals[]);
    void *arg;
};

/* Searches from x, in at most `most` evaluations, and sets x to the best at which all runs have residuals, as
 * they must have where it begins. False if at() returned false. */
bool fit_least(const struct fit_problem *p, double x[], unsigned most);
const char *fit_least_method(size_t numbers);

/* slope[i * numbers + k] = d residual i / d number k at x, where the residuals are here[], from residuals
 * `step` below and above x: on one side at an end of the range, or where the other side has none. NAN:
 * neither side has one. False if at() returned false. */
bool fit_slopes(const struct fit_problem *p, const double x[], const double here[], double step,
                double slope[]);

/* NAN if one of them is. */
double fit_rms(const double residuals[], size_t count);
#endif
