/* run_again.h - a command of touchstone run, taken apart so that it can be run again with other numbers of
 * the machine: its results (--json, --trace ...), limits and the simulator's own options are left out. */
#ifndef CLI_RUN_AGAIN_H
#define CLI_RUN_AGAIN_H
#include "cli/commands.h"
#include "cli/installation.h"
#include "config/config.h"
#include "lab/jobs/rerun.h"
#include "lab/trace/trace_model.h"

struct run_again {
    struct rerun_command command;
    /* what command points to */
    char **options, *machine;
    struct cfg_machine *cfg; /* the machine, with the command's settings */
};

/* A command line that works in that folder. The texts of its parts, but not their lists, must outlive *again.
 * False with *error malloc'd if the machine file cannot be read. */
bool run_again_of(const struct cli_run_parts *parts, const char *folder,
                  const struct cli_installation *places, struct run_again *again, char **error);
/* The command of a trace, which must outlive *again. */
bool run_again_from(const struct trace *t, const struct cli_installation *places, struct run_again *again,
                    char **error);
/* Can the machine take these settings, ended by NULL, behind those of the command? If not: why, malloc'd. */
char *run_again_refuses(const struct run_again *again, const struct cli_installation *places,
                        const char *const set[]);
void run_again_free(struct run_again *again);
#endif
