/* race_json.h - the races of a run, as JSON. */
#ifndef OBSERVE_RACE_JSON_H
#define OBSERVE_RACE_JSON_H
#include <jansson.h>
#include "observe/race_report.h"

/* An array of objects, one for each race. */
json_t *race_json(const struct race_reports *t);
/* Writes an object with the array and the number of those suppressed, whole or not at all. Returns NULL, or a
 * malloc'd error. */
char *race_json_write(const struct race_reports *t, const char *path);
#endif
