/* sensitivity.h - the sensitivity of a run's time to the numbers of its machine file: the run is made again
 * with each number changed by 1 %, or by the least step that the number has, and what becomes of its time
 * is exact.
 *
 * Not changed are texts, numbers that are 0, and the clocks of the processor's operations (cpu.*): nxcc has
 * counted those into the program, and node.clock_mhz stands for all of them. */
#ifndef LAB_SENSITIVITY_SENSITIVITY_H
#define LAB_SENSITIVITY_SENSITIVITY_H
#include "config/machine_numbers.h"
#include "lab/jobs/rerun.h"

struct sensitive_number {
    const struct cfg_number *number;
    const char *unit; /* "us/B"; "" for a number of things */
    double value, step;
    char *refused;      /* why the number cannot be changed so little; NULL: it can */
    size_t run;         /* its re-run */
    double per_percent; /* seconds, for 1 % more; NAN: the re-run failed */
};

struct sensitivity {
    struct cfg_numbers *numbers;
    struct sensitive_number
        *list; /* in the file's order; after sensitivity_run(), the largest effect first */
    size_t count;
    struct reruns runs; /* the first is the run as it was */
};

/* Chooses the numbers and steps. cfg: the machine with the run's settings. NULL with *error malloc'd. */
struct sensitivity *sensitivity_new(const struct cfg_machine *cfg, char **error);
/* Makes the re-runs. False with *error malloc'd: they cannot be made, or the first does not take the time of
 * the run. */
bool sensitivity_run(struct sensitivity *s, const struct rerun_place *p, vtime end, char **error);
void sensitivity_free(struct sensitivity *s);
#endif
