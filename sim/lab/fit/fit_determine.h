/* fit_determine.h - the numbers of a fit that its residuals determine, and how well. */
#ifndef LAB_FIT_FIT_DETERMINE_H
#define LAB_FIT_FIT_DETERMINE_H
#include "lab/fit/fit_least.h"

enum fit_standing {
    FIT_DETERMINED,
    FIT_NO_INFLUENCE, /* no residual changes with the number */
    FIT_OPEN,         /* the standard error is more than a quarter of the range, or no slope is known */
    FIT_COMBINED,     /* only a combination with other numbers is determined */
};

struct fit_number {
    enum fit_standing standing;
    double error;               /* the standard error; INFINITY: any value will do */
    bool with[FIT_MAX_NUMBERS]; /* FIT_COMBINED: the other numbers of the combination */
};

/* Uses the singular values of the slopes (fit_slopes()): the standard error of a combination of numbers is
 * the residuals' scatter divided by the combination's singular value. A residual that has a slope of NAN
 * determines nothing. scatter: the residuals' standard deviation, or the measurements' accuracy if that is
 * more. */
void fit_determine(const double slope[], size_t residuals, size_t numbers, double scatter,
                   struct fit_number of[]);
#endif
