/* result_cache.h - results of earlier runs, of all studies: a file for each point, named by the digest of its
 * inputs.
 *
 *     FOLDER/3f/3f09...      a line (journal_line.h) whose record holds the inputs, too
 *
 * A result is used only if its line is undamaged and its inputs are equal, member by member. Any number of
 * processes may share a folder, since files are atomic (atomic_file.h). The folder may be removed at any
 * time.
 */
#ifndef LAB_JOBS_RESULT_CACHE_H
#define LAB_JOBS_RESULT_CACHE_H
#include "lab/jobs/digest.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

/* The default folder: $XDG_CACHE_HOME/touchstone, or ~/.cache/touchstone. Malloc'd; NULL if neither variable
 * is set. */
char *result_cache_folder(void);
/* The record of a point with these inputs, owned by the caller; NULL if there is none. Writes about damage to
 * notes. */
json_t *result_cache_find(const char *folder, struct digest key, const json_t *inputs, FILE *notes);
/* Adds a record. A failure is written to notes and has no other effect; the value is then false. */
bool result_cache_add(const char *folder, struct digest key, json_t *inputs, json_t *record, FILE *notes);
#endif
