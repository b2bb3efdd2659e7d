/* baseline.h - the figures of studies in a file, for touchstone check to compare later runs with (compare.h).
 *
 *     { "compilers": { "table1": "GCC 12.2.0" },
 *       "format": "touchstone baseline 1",
 *       "studies": { "table1": { "nodes 8": {
 *         "figures": { "bytes": 123, "digest": "...", "messages": 45, "total_s": 142.9, ... },
 *         "where": { "others": { "nodes": 7, "functions": { "mix (trilinear.c)": 12.5, ... },
 *                                "system": { "copying": 0.1, ... },
 *                                "idle": { "crecv": 3.2, ... }, ... } } } } } }
 *
 * Keys are sorted and reals have 15 digits, so that equal results are equal files. `where` has the seconds of
 * all nodes of a class: by function if the study has a profile, otherwise under "all of the program".
 */
#ifndef LAB_CHECK_BASELINE_H
#define LAB_CHECK_BASELINE_H
#include <jansson.h>
#include <stdbool.h>

/* An empty baseline, owned by the caller. */
json_t *baseline_new(void);
/* Reads a baseline, owned by the caller. NULL with *error malloc'd: the file, its line, what is wrong. */
json_t *baseline_read(const char *path, char **error);
/* Writes the baseline as an atomic file. False with *error malloc'd. */
bool baseline_write(const json_t *baseline, const char *path, char **error);

/* The points of a study, NAME: POINT; adds the study if it is missing. Borrowed. */
json_t *baseline_study(json_t *baseline, const char *study);
/* The points of a study; NULL if it is missing. Borrowed. */
const json_t *baseline_find(const json_t *baseline, const char *study);

/* By which compiler the study's program was made (compiler.h); NULL if that is not known. */
const char *baseline_compiler(const json_t *baseline, const char *study);
void baseline_set_compiler(json_t *baseline, const char *study, const char *compiler);
#endif
