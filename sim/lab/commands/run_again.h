/* run_again.h - the command of a trace, taken apart so that it can be run again with other numbers of the
 * machine. */
#ifndef CLI_RUN_AGAIN_H
#define CLI_RUN_AGAIN_H
#include "cli/installation.h"
#include "lab/why/rerun.h"

struct run_again {
    struct rerun_command command;
    /* what command points to */
    char **options, *nodes;
    struct cfg_machine *cfg;
};

/* Takes the command of a trace apart: its results (--json, --trace ...), limits and the simulator's own
 * options are left out. The trace must outlive *again. False with *error malloc'd if the machine file
 * cannot be read any more. */
bool run_again_from(const struct trace *t, const struct cli_installation *places, struct run_again *again,
                    char **error);
void run_again_free(struct run_again *again);
#endif
