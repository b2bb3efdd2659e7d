/* result_paths.h - where the results of a run go: to files, each with room for one, or to standard output. */
#ifndef CLI_RESULT_PATHS_H
#define CLI_RESULT_PATHS_H
#include <stdbool.h>

enum { RESULT_MOST_PATHS = 8 };

struct result_paths {
    const char *path[RESULT_MOST_PATHS]; /* "-": standard output. NULL: not asked for */
};

/* How many results there are; of them, on standard output. */
int result_paths_count(const struct result_paths *r);
int result_paths_dashes(const struct result_paths *r);
/* A path of two results, of which one would be lost; NULL: there is none. */
const char *result_paths_twice(const struct result_paths *r);
/* Can all be written, as far as their folders tell? False with *error, malloc'd: a run that takes an hour
 * should not end with a result that has no folder. */
bool result_paths_possible(const struct result_paths *r, char **error);
#endif
