/* fit.h - touchstone fit: finds the values of a machine's settings, of a program's arguments or of cost
 * factors for which a study's figures come nearest to measurements. The study file defines the fit in a
 * group:
 *
 *     fit = {
 *         parameters = (
 *             { name = "send"; set = "system.short_send_us={}"; from = 10.0; to = 200.0; start = 50.0; },
 *             { name = "k"; arguments = "-k {}"; from = 1.0; to = 4.0; logarithmic = true; } );
 *         measurements = "measured.csv";
 *         weights = "relative";
 *     };
 *
 * A parameter's value, with six digits, replaces {} in a setting of the machine or in arguments of the
 * program. A cost factor (factor = "slice.c") is given to the compiler: each value needs a build of the
 * program, by the command build = "nxcc -O2 --factors {factors} -o {program} prog.c" in the study file's
 * folder. The search covers the range evenly, or by its logarithm if `logarithmic`; it begins at `start`, or
 * else in the middle.
 *
 * measured.csv has a line of names and then lines of values. A column is an axis of the study, a figure, or
 * `weight`; an empty cell or - is not measured. measurements may also be a list of groups: ( { nodes = 2;
 * total_s = "0.0150"; } ). A residual is (computed - measured) / measured, in percent, times the line's
 * weight; with weights = "rounding" it is in half units of the measurement's last digit.
 */
#ifndef LAB_FIT_FIT_H
#define LAB_FIT_FIT_H
#include "lab/study/study.h"

struct fit_options {
    struct study_options study; /* for each evaluation; the fit sets `set` and `arguments` */
    const char *constants;      /* the file to write */
    const char *json;           /* a file for the result as JSON, or NULL */
    unsigned most;              /* evaluations at most */
    FILE *out;                  /* for the result */
    FILE *progress;             /* for a line about each evaluation */
    int *signal;                /* becomes the signal that ended the fit with FIT_ERROR, if one did */
};

enum fit_end {
    FIT_DONE,
    FIT_UNDETERMINED, /* done, but the data do not determine some parameters, as `out` tells */
    FIT_ERROR,        /* *error is a malloc'd text for the user; nothing was written */
};
enum fit_end fit_run(const struct fit_options *options, char **error);
#endif
