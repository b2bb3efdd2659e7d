/* summary.h - the figures of a run: a few lines for people, and a JSON file for programs. */
#ifndef OBSERVE_SUMMARY_H
#define OBSERVE_SUMMARY_H
#include "machine/machine.h"
#include "observe/race_report.h"

/* Writes the lines: times, messages, where the nodes' time went (separately for nodes with handlers), memory,
 * races, digest. verbose: also what the simulator's threads did, which differs from run to run. */
void summary_print(const struct machine *m, const struct race_reports *races, bool verbose, FILE *f);
/* Writes the JSON file, whole or not at all. Returns NULL, or a malloc'd error. */
char *summary_json(const struct machine *m, const struct race_reports *races, const char *path);
#endif
