/* explore_report.h - what an exploration has found, as text. */
#ifndef LAB_EXPLORE_EXPLORE_REPORT_H
#define LAB_EXPLORE_EXPLORE_REPORT_H
#include "lab/explore/explore.h"

/* The same for the same runs, but for its last line, which has times of the host. */
void explore_print(const struct explore *x, FILE *out);
/* The command that repeats the run, in the current folder; malloc'd. */
char *explore_repeat(const struct explore *x, const struct explored *run);
#endif
