/* fit.h - touchstone fit: the numbers of a machine, or of a program's arguments, with which a study comes nearest to
 * measurements. The study file says which, in a group of its own:
 *
 *     fit = {
 *         parameters = (
 *             { name = "latency"; set = "net.latency_us={}"; from = 10.0; to = 200.0; start = 50.0; },
 *             { name = "k"; arguments = "-k {}"; from = 1.0; to = 4.0; logarithmic = true; } );
 *         measurements = "measured.csv";
 *         weights = "relative";
 *     };
 *
 * A third kind is a cost factor of the compiler's (factor = "slice.c"), for which the program is built anew, by
 * build = "nxcc -O2 --factors {factors} -o {program} prog.c -lm" in the study file's folder.
 *
 * A parameter is from its range, evenly or by its logarithm; it starts at `start`, else in the middle. Its text, of six
 * digits, stands for {} in a setting of the machine or in words after the program's arguments.
 *
 * measured.csv has a line of names and then lines of values. A column is an axis of the study, a figure, or `weight`;
 * empty cells and - are not measured. measurements may also be a list of groups: ( { nodes = 2; total_s = "0.0150"; } ).
 * A residual is (computed - measured) / measured, in percent; with weights = "rounding" it is in halves of a unit of the
 * measurement's last digit; times the line's weight.
 */
#ifndef LAB_FIT_FIT_H
#define LAB_FIT_FIT_H
#include "lab/study/study.h"

struct fit_options {
    struct study_options study; /* of each evaluation; set and arguments are the fit's */
    const char *constants;      /* the file to write */
    unsigned most;              /* evaluations of the search */
    FILE *out;                  /* what came of it */
    FILE *progress;             /* a line for each evaluation */
};

enum fit_end {
    FIT_DONE,
    FIT_UNDETERMINED, /* also done; some parameters are not determined: they were named */
    FIT_ERROR,        /* *error is a malloc'd text for the user; nothing was written */
};
enum fit_end fit_run(const struct fit_options *options, char **error);
#endif
