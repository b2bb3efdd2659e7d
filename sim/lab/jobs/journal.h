/* journal.h - the results of a study as they come: DIR/journal, a line each (journal_line.h), only ever appended to.
 *
 * A line is on the disk before journal_add() returns, so that kill -9 loses nothing that was added. Several processes may
 * add: each locks the file for it. What was being written when a writer died is a line without an end: it is cut off by
 * the next who adds. Any other line that is not whole is damage: it is named, and counts as not there.
 *
 * Memory does not grow with the journal, but for a table of keys and places that the system can page out (scratch_memory.h).
 */
#ifndef LAB_JOBS_JOURNAL_H
#define LAB_JOBS_JOURNAL_H
#include "lab/jobs/journal_line.h"

#include <stdio.h>

/* Opens DIR/journal, makes it if need be, and reads it; damage is said on notes. NULL with *error malloc'd. */
struct journal *journal_open(const char *dir, FILE *notes, char **error);
void journal_close(struct journal *j);

/* Takes note of what others have added. */
void journal_refresh(struct journal *j);
/* Adds a line, on the disk at once if `safe`; what is added without is lost at most when the computer stops. False with
 * *error malloc'd. */
bool journal_add(struct journal *j, struct digest key, enum journal_line_state state, const json_t *record,
                 bool safe, char **error);

/* Points that have failed so far count as not run. */
void journal_forget_failed(struct journal *j);

/* Calls visit with the last record of each point, in no order. */
void journal_each(const struct journal *j, void (*visit)(void *arg, struct digest key, const json_t *record),
                  void *arg);
/* How many points have a line. */
size_t journal_count(const struct journal *j);

/* How the point of that key ended, by its last line; false: there is none. */
bool journal_find(const struct journal *j, struct digest key, enum journal_line_state *state);
/* That line's record, the caller's; NULL: there is none. */
json_t *journal_record(const struct journal *j, struct digest key);
#endif
