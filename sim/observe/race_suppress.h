/* race_suppress.h - races that the user does not want to be told of: a text file, a line each. `#` begins a
 * comment. Words may have * and ?, as file names in a shell.
 *
 *     file queue.c:12         one of the two accesses is in that line
 *     file queue.c            ... in that file
 *     variable queue*         of a variable, as the report names it
 *     function on_*           one of the two accesses is in a function, or in one that it has called */
#ifndef OBSERVE_RACE_SUPPRESS_H
#define OBSERVE_RACE_SUPPRESS_H
#include <stdbool.h>
#include "observe/race_report.h"

struct race_suppressions;
/* Returns NULL with *error (malloc'd), which names file and line, if the file is not as above. */
struct race_suppressions *race_suppress_read(const char *path, char **error);
void race_suppress_free(struct race_suppressions *s);
/* NULL suppresses nothing. */
bool race_suppress_matches(const struct race_suppressions *s, const struct race_report *r);
#endif
