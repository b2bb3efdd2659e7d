/* run_trace.h - the trace file of a run: its head, and when it begins and ends. */
#ifndef OBSERVE_RUN_TRACE_H
#define OBSERVE_RUN_TRACE_H
#include "files/atomic_file.h"
#include "machine/machine.h"

struct run_trace_options {
    const char *path;
    vtime from, to;    /* what overlaps [from, to] is written; to 0: to the end */
    const bool *nodes; /* by number, of node_count; NULL: all */
    uint32_t node_count;
    char *const *command; /* the whole command, ended by NULL */
    const char *version;  /* of touchstone */
};

struct run_trace {
    struct atomic_file file;
    struct recorder *recorder; /* NULL: the run is in no trace */
};

/* Opens the file and has the machine's run recorded; the machine has been made and has not run. *o must
 * last as long. False with *error, a malloc'd text. */
bool run_trace_begin(struct run_trace *t, struct machine *m, const struct run_trace_options *o, char **error);
/* Writes the end of a machine that has run; the file is complete. False with *error. */
bool run_trace_end(struct run_trace *t, const struct machine *m, char **error);
#endif
