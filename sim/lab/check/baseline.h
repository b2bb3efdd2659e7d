/* baseline.h - what studies came to, kept in a file to compare later runs with (compare.h).
 *
 *     { "format": "touchstone baseline 1",
 *       "studies": { "table1": { "nodes 8": {
 *           "figures": { "bytes": 123, "digest": "...", "messages": 45, "total_s": 142.9, ... },
 *           "where":   { "others": { "nodes": 7, "functions": { "mix (trilinear.c)": 12.5, ... },
 *                                    "system": { "copying": 0.1, ... }, "idle": { "crecv": 3.2, ... }, ... } } } } } }
 *
 * Keys are sorted and reals have 15 digits, so that equal results are equal files and a difference is a line. `where` is
 * in seconds of all nodes of a class together. With a profile it has every function; without, all of the program's
 * computing is one.
 */
#ifndef LAB_CHECK_BASELINE_H
#define LAB_CHECK_BASELINE_H
#include <jansson.h>
#include <stdbool.h>

/* An empty one. */
json_t *baseline_new(void);
/* NULL with *error a malloc'd text for the user: the file, its line, what is wrong. */
json_t *baseline_read(const char *path, char **error);
/* Writes the file, whole or not at all. */
bool baseline_write(const json_t *baseline, const char *path, char **error);

/* The points of a study, NAME: POINT; made if it has none. Borrowed. */
json_t *baseline_study(json_t *baseline, const char *study);
/* Its points as they are in the file, NULL if it is not there. Borrowed. */
const json_t *baseline_find(const json_t *baseline, const char *study);

/* A study's point (study_each() in study.h) as a baseline has it; axes: an object whose keys are the names of the study's axes.
 * What differs from run to run on one host, or says where files are, is left out. */
json_t *baseline_point(const json_t *point, const json_t *axes);
/* What it is called: "nodes 8, group 4"; malloc'd. */
char *baseline_name(const json_t *point, const json_t *axes);
#endif
