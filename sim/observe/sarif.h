/* sarif.h - what a run has found, as SARIF 2.1.0 (OASIS), which editors and code hosts show beside the lines:
 * races, a deadlock, an error of --asan or a crash. */
#ifndef OBSERVE_SARIF_H
#define OBSERVE_SARIF_H
#include "machine/machine.h"
#include "observe/race_report.h"

/* Writes the file, whole or not at all; without findings its list of results is empty. version: touchstone's.
 * Returns NULL, or a malloc'd error. */
char *sarif_write(const struct machine *m, const struct race_reports *races, const char *version,
                  const char *path);
#endif
