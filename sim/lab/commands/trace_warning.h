/* trace_warning.h - warnings that a program may have been compiled since its trace was made, or is gone. */
#ifndef LAB_COMMANDS_TRACE_WARNING_H
#define LAB_COMMANDS_TRACE_WARNING_H
#include "lab/trace/trace_model.h"

/* path: the trace's. Says nothing if its programs' files are there, and older. */
void cli_trace_warn(const char *command, const struct trace *t, const char *path);
#endif
