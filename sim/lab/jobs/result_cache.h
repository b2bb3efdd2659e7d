/* result_cache.h - results of points run before, in whatever study and folder: a file for each, named by the digest of its inputs.
 *
 *     FOLDER/3f/3f09...      a line (journal_line.h) whose record has the inputs too
 *
 * What is found is used only if its inputs are equal, member by member, and the line is whole. Files are written under
 * another name and then renamed, so that any number of processes may share a folder. All of it may be removed at any time.
 */
#ifndef LAB_JOBS_RESULT_CACHE_H
#define LAB_JOBS_RESULT_CACHE_H
#include "lab/jobs/digest.h"

#include <jansson.h>
#include <stdio.h>

/* The folder where nothing else is said: $XDG_CACHE_HOME/touchstone, or ~/.cache/touchstone. Malloc'd; NULL: neither. */
char *result_cache_folder(void);
/* The record of a point with these inputs, the caller's; NULL: none. Damage is said on notes. */
json_t *result_cache_find(const char *folder, struct digest key, const json_t *inputs, FILE *notes);
/* Keeps it; a failure is no more than that it is not kept, and said on notes. */
void result_cache_add(const char *folder, struct digest key, json_t *inputs, json_t *record, FILE *notes);
#endif
