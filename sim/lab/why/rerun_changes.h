/* rerun_changes.h - the numbers of a machine that trace why changes when it runs the command of a trace
 * again: what if some of its work took no time?
 *
 * The first re-run is the command as it was. If that does not take the time of the trace, then the program,
 * its input or the machine file is another now, and nothing can be said. */
#ifndef LAB_WHY_RERUN_CHANGES_H
#define LAB_WHY_RERUN_CHANGES_H
#include "config/config.h"
#include "lab/jobs/rerun.h"
#include "lab/trace/trace_model.h"

struct rerun_options {
    struct rerun_command command;
    const struct cfg_machine *cfg; /* the machine, with the command's settings */
    const char *const *set;        /* the user's own settings, ended by NULL: one more re-run; NULL: none */
    double cpu;                    /* processors so many times faster: one more re-run; 0: none */
    unsigned at_once;              /* so many children at a time */
    FILE *progress;
};

/* Runs the command again with each change that is worth while for the trace. False with *error malloc'd if it
 * cannot be run any more, or takes another time now. The caller frees *r in any case. */
bool rerun_all(const struct trace *t, const struct rerun_options *o, struct reruns *r, char **error);
#endif
