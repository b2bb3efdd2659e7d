/* runs_journal.h - runs of the tables that have been done, in DIR/journal (journal.h): a command that was interrupted goes on.
 * A run is what it depends on, as a study's point is (inputs.h). Only runs that went well are kept. */
#ifndef LAB_TABLES_RUNS_JOURNAL_H
#define LAB_TABLES_RUNS_JOURNAL_H
#include "lab/tables/table_runs.h"
#include "lab/tables/tables.h"

/* NULL with *error malloc'd: another command is at work in DIR, or a file cannot be read. */
struct runs_kept *runs_kept_open(const struct tables_options *o, const struct paper *paper, char **error);
void runs_kept_close(struct runs_kept *k);
/* Sets the run's outcome if it is kept. */
bool runs_kept_find(struct runs_kept *k, struct run *run);
/* Keeps it; a failure is said, and costs no more than that. */
void runs_kept_add(struct runs_kept *k, const struct run *run);
#endif
