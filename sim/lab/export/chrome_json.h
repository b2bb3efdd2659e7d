/* chrome_json.h - a trace as Chrome's trace events, for Perfetto. */
#ifndef LAB_EXPORT_CHROME_JSON_H
#define LAB_EXPORT_CHROME_JSON_H
#include <stdbool.h>
#include <stdio.h>
#include "lab/export/export_progress.h"
#include "lab/export/timeline.h"

/* True. Whether `out` failed, it says itself. error: as other writers have it. */
bool chrome_json_write(const struct timeline *l, FILE *out, const struct export_progress *p, char **error);
#endif
