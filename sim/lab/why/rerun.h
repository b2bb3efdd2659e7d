/* rerun.h - runs the command of a trace again, with other numbers of the machine: what if some of its work
 * took no time? Unlike an estimate from the critical path, that is exact: all that follows from the change
 * is in it.
 *
 * Every re-run is a child process touchstone run in the folder of the first run. The first one is the
 * command as it was. If that does not take the time of the trace, then the program, its input or the
 * machine file is another now, and nothing can be said. Each re-run has a copy of the folder for /cfs, if
 * the command names one. */
#ifndef LAB_WHY_RERUN_H
#define LAB_WHY_RERUN_H
#include <stdio.h>
#include "config/config.h"
#include "lab/trace/trace_model.h"

/* The command, in parts: what goes before the settings, and from the program on. Both are ended by NULL. */
struct rerun_command {
    char *const *options, *const *program;
    const char *cfs;               /* the folder for /cfs, as the option --cfs; NULL: none */
    const struct cfg_machine *cfg; /* the machine, with the command's settings */
};

/* One re-run: what it changes, and what came of it. */
struct rerun {
    char *what; /* a clause: "if entering and leaving handlers took no time" */
    char *key;  /* for JSON: "interrupts" */
    char **set; /* settings KEY=VALUE of the machine, ended by NULL */
    bool done;
    vtime end;   /* if done */
    char *error; /* if not: in one line */
};

struct reruns {
    struct rerun *list;
    size_t count;
};

struct rerun_options {
    struct rerun_command command;
    const char *const *set; /* the user's own settings, ended by NULL: one more re-run; NULL: none */
    double cpu;             /* processors so many times faster: one more re-run; 0: none */
    unsigned at_once;       /* so many children at a time */
    FILE *progress;
};

/* Runs them all. False with *error malloc'd if the command cannot be run any more, or takes another time
 * now. The caller frees *r in any case. */
bool rerun_all(const struct trace *t, const struct rerun_options *o, struct reruns *r, char **error);
void reruns_free(struct reruns *r);
#endif
