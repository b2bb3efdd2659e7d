/* compare_export.h - comparisons (compare.h) for programs: as JSON, and as annotations of GitHub Actions. */
#ifndef LAB_CHECK_COMPARE_EXPORT_H
#define LAB_CHECK_COMPARE_EXPORT_H
#include "lab/check/compare.h"

#include <stdio.h>

/* Writes all points with their verdicts, and the figures that differ: share/schemas/check.schema.json. */
void compare_write_json(struct compare_point *const points[], size_t count, FILE *out);
/* Writes a line for each point that is a failure, which GitHub Actions shows beside the change:
 * ::error title=study: point::total_s 1 -> 2 (...). */
void compare_write_github(struct compare_point *const points[], size_t count, FILE *out);
#endif
