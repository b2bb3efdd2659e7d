/* runs_journal.h - the finished runs of the tables, in DIR/journal (journal.h), from which an interrupted
 * command resumes. A run is identified by the digest of its inputs, as a study's point (inputs.h). Failed
 * runs are not added. */
#ifndef LAB_TABLES_RUNS_JOURNAL_H
#define LAB_TABLES_RUNS_JOURNAL_H
#include "lab/tables/table_runs.h"
#include "lab/tables/tables.h"

/* Opens the journal and locks DIR. NULL with *error malloc'd if another command works in DIR or a file cannot
 * be read. */
struct runs_journal *runs_journal_open(const struct tables_options *o, const struct paper *paper,
                                       char **error);
void runs_journal_close(struct runs_journal *k);
/* Sets the run's outcome from the journal. False if the journal has none. */
bool runs_journal_find(struct runs_journal *k, struct run *run);
/* Adds a run. A failure is printed and has no other effect. */
void runs_journal_add(struct runs_journal *k, const struct run *run);
#endif
