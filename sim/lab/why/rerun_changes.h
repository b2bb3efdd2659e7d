/* rerun_changes.h - which numbers of a machine a re-run changes. */
#ifndef LAB_WHY_RERUN_CHANGES_H
#define LAB_WHY_RERUN_CHANGES_H
#include "lab/why/rerun.h"

/* The re-runs that are worth while for the trace: the first is the command as it was, without settings. */
struct reruns rerun_changes(const struct trace *t, const struct rerun_options *o);
#endif
