/* outcome.h - the result of one run: the figures that the program printed, and the figures of the simulator
 * (run --json).
 *
 * A program prints a figure as a line "key value" or "key value value ..."; other lines are ignored.
 */
#ifndef LAB_JOBS_OUTCOME_H
#define LAB_JOBS_OUTCOME_H
#include <jansson.h>
#include "lab/jobs/process_pool.h"

struct outcome {
    json_t *printed; /* object: a number, or an array of numbers, for each key the program printed */
    json_t *run;     /* object: the simulator's summary of the run */
    double wall_time_s;
    char *error; /* why there are no figures (both objects are NULL); NULL if there are */
};

/* Reads both kinds of figures; out is the program's standard output. The program must have printed the key
 * `required`, unless NULL. */
struct outcome outcome_read(const char *out, const char *json_path, const char *required);
/* The outcome of a job that has ended, or was not run. */
struct outcome outcome_of(const struct pool_job *job, const char *json_path, const char *required);
void outcome_clear(struct outcome *o);

/* The number of that key in an object, which may be NULL; NAN if there is none. */
double figure_of(const json_t *figures, const char *key);
/* The number that the program printed with that key; NAN if there is none. */
double outcome_figure(const struct outcome *o, const char *key);
#endif
