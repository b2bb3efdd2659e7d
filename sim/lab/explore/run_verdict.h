/* run_verdict.h - what a run came to, as far as runs are compared: how it ended, and what it wrote. */
#ifndef LAB_EXPLORE_RUN_VERDICT_H
#define LAB_EXPLORE_RUN_VERDICT_H
#include <jansson.h>
#include <regex.h>
#include <stdbool.h>

/* What of the output must be equal. */
struct verdict_rules {
    const regex_t *same; /* only lines that match; NULL: all lines */
    bool ordered;        /* lines must come in one order; otherwise nodes' lines may mix */
    bool file_only;      /* only the file that runs are compared by, if there is one */
};

/* The record of a run, owned by the caller:
 *
 *     end          "ended", "deadlock", "crashed" ...: as run --json has it
 *     group        digest: equal for runs that count as the same. Of runs that ended: their output, and the
 *                  file; of others: the lines of source in the message, without times
 *     lines        digest of the lines that count, in the order printed; absent if the run did not end
 *     shown        what was compared, its first lines
 *     message      why the run did not end; absent if it did
 *     virtual_time_s, host_files, and races if the program was built by nxcc --races: as run --json has them
 *
 * out: the run's standard output; json: its figures (run --json); file: the path of the file that runs are
 * compared by, or NULL. NULL if the figures cannot be read: the run has not come to its end. */
json_t *verdict_of(const struct verdict_rules *rules, const char *out, const char *json, const char *file);
/* Has the run of the record not left the file that runs are compared by? */
bool verdict_lacks_file(const json_t *record);
#endif
