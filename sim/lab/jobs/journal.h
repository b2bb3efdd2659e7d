/* journal.h - DIR/journal, the finished points of a study: one line a point (journal_line.h), only ever
 * appended to.
 *
 * A line is on the disk before journal_add() returns: kill -9 loses nothing that was added. Several processes
 * may add lines; each locks the file meanwhile. A writer that dies leaves an incomplete last line, which the
 * next writer cuts off. Any other incomplete line is damage: a note names it, and its point counts as not
 * run.
 *
 * Memory does not grow with the journal, except for a hash table of the points, which the system can page out
 * (scratch_memory.h).
 */
#ifndef LAB_JOBS_JOURNAL_H
#define LAB_JOBS_JOURNAL_H
#include "lab/jobs/journal_line.h"

#include <stdio.h>

/* Opens DIR/journal, or makes it, and reads it. Writes about damaged lines to notes. NULL with *error
 * malloc'd. */
struct journal *journal_open(const char *dir, FILE *notes, char **error);
void journal_close(struct journal *j);

/* Reads the lines that other processes have added. */
void journal_refresh(struct journal *j);
/* Adds a line. If `safe`, the line is on the disk on return; otherwise only a stop of the computer can lose
 * it. False with *error malloc'd. */
bool journal_add(struct journal *j, struct digest key, enum journal_line_state state, const json_t *record,
                 bool safe, char **error);

/* From now on, points that have failed so far count as not run. */
void journal_forget_failed(struct journal *j);

/* Calls visit with the last record of each point, in arbitrary order. */
void journal_each(const struct journal *j, void (*visit)(void *arg, struct digest key, const json_t *record),
                  void *arg);
/* How many points have a line. */
size_t journal_count(const struct journal *j);
/* How many bytes of the file have been read, all of them complete lines. */
uint64_t journal_size(const struct journal *j);

/* Sets *state, unless NULL, from the last line of the point of that key. False if the point has no line. */
bool journal_find(const struct journal *j, struct digest key, enum journal_line_state *state);
/* The record of the point's last line, owned by the caller; NULL if the point has no line. */
json_t *journal_record(const struct journal *j, struct digest key);
#endif
