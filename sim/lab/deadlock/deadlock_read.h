/* deadlock_read.h - reports of deadlocks, read again. */
#ifndef LAB_DEADLOCK_DEADLOCK_READ_H
#define LAB_DEADLOCK_DEADLOCK_READ_H
#include <jansson.h>
#include "nx_api/waitfor/waitfor.h"

/* The report in a JSON file, of `touchstone run --deadlock` or in the results of `run --json`: analysed
 * anew, so that its text is what the run has said. The caller frees it (waitfor_free). NULL with *error,
 * malloc'd, which names the file. */
struct waitfor *deadlock_read(const char *path, char **error);
/* The same of a report in memory, or in results of a run: NULL: j is neither. */
struct waitfor *deadlock_of_json(const json_t *j);
#endif
