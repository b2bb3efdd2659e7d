/* runs_journal.h - runs of the tables that have been done, in DIR/journal (journal.h): a command that was interrupted goes on.
 * A run is what it depends on, as a study's point is (inputs.h). Only runs that went well are kept. */
#ifndef LAB_TABLES_RUNS_JOURNAL_H
#define LAB_TABLES_RUNS_JOURNAL_H
#include "lab/tables/table_runs.h"
#include "lab/tables/tables.h"

/* NULL with *error malloc'd: another command is at work in DIR, or a file cannot be read. */
struct runs_journal *runs_journal_open(const struct tables_options *o, const struct paper *paper,
                                       char **error);
void runs_journal_close(struct runs_journal *k);
/* Sets the run's outcome if it is kept. */
bool runs_journal_find(struct runs_journal *k, struct run *run);
/* Keeps it; a failure is said, and costs no more than that. */
void runs_journal_add(struct runs_journal *k, const struct run *run);
#endif
