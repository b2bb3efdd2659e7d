/* outcome.h - what one run of a program came to: the figures the program printed and the simulator's own.
 *
 * A program prints a figure as a line "key value" or "key value value ..."; other lines are ignored. The simulator
 * writes its figures with --json.
 */
#ifndef LAB_JOBS_OUTCOME_H
#define LAB_JOBS_OUTCOME_H
#include <jansson.h>

struct outcome {
    json_t *printed; /* object: a number, or an array of numbers, for each key the program printed */
    json_t *run;     /* object: what the simulator said of the run as a whole */
    double wall_time_s;
    char *error; /* NULL, or why there are no figures; then the objects are NULL */
};

/* Reads both; out is the program's standard output. `required` is a key that must be there, or
 * NULL. */
struct outcome outcome_read(const char *out, const char *json_path, const char *required);
void outcome_clear(struct outcome *o);

/* The number of that name in an object, which may be NULL; NAN when there is none. */
double figure_of(const json_t *figures, const char *key);
/* The printed figure of that name; NAN when there is none. */
double outcome_figure(const struct outcome *o, const char *key);
#endif
