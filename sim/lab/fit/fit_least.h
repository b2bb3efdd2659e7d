/* fit_least.h - the numbers that make residuals least, and what the residuals say of them. Knows nothing of studies.
 *
 * All numbers are between 0 and 1, the ends of their ranges. Residuals are without unit, each in terms of how far it may
 * be off; their root mean square is made least. They need not be smooth: no derivative is asked for (BOBYQA, M. J. D.
 * Powell, University of Cambridge, report DAMTP 2009/NA06; for a single number Nelder and Mead's simplex).
 */
#ifndef LAB_FIT_FIT_LEAST_H
#define LAB_FIT_FIT_LEAST_H
#include <stdbool.h>
#include <stddef.h>

enum { FIT_MAX_NUMBERS = 16 };

struct fit_problem {
    size_t numbers;   /* 1 to FIT_MAX_NUMBERS */
    size_t residuals; /* 1 or more */
    /* The residuals at x; false when it cannot go on, and is not asked again. */
    bool (*at)(void *arg, const double x[], double residuals[]);
    void *arg;
};

/* From x, to x; `most` evaluations. false when at() was. */
bool fit_least(const struct fit_problem *p, double x[], unsigned most);
const char *fit_least_method(size_t numbers);

/* d residual / d number at x, from residuals `step` below and above (on one side only at an end): slope[i * numbers + k]
 * of residual i and number k. */
bool fit_slopes(const struct fit_problem *p, const double x[], double step, double slope[]);

double fit_rms(const double residuals[], size_t count);

/* --- what the residuals determine (fit_determine.c) --- */

enum fit_standing {
    FIT_DETERMINED,
    FIT_NO_INFLUENCE, /* no residual changes with it */
    FIT_OPEN,         /* its standard error is more than a quarter of its range */
    FIT_TOGETHER,     /* only together with others: what these say of it is a combination */
};

struct fit_number {
    enum fit_standing standing;
    double error;               /* standard; INFINITY: any value will do */
    bool with[FIT_MAX_NUMBERS]; /* together: with those */
};

/* From the slopes' singular values: a combination of numbers is as uncertain as the residuals' scatter (their standard
 * deviation, or how exact the measurements are, whichever is more) divided by its singular value. */
void fit_determine(const double slope[], size_t residuals, size_t numbers, double scatter,
                   struct fit_number of[]);
#endif
