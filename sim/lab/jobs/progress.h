/* progress.h - shows a pool's progress: one line that is rewritten on a terminal, a line a job elsewhere. */
#ifndef LAB_JOBS_PROGRESS_H
#define LAB_JOBS_PROGRESS_H
#include "lab/jobs/process_pool.h"

#include <stdio.h>

struct progress {
    FILE *to;
    bool live; /* a terminal: one line, rewritten */
};

/* A watcher for pool_run() that shows progress on `to`. p must outlive the pool. */
struct pool_watcher progress_watcher(struct progress *p, FILE *to);
/* For callers of pool_run_from(), who count themselves. */
struct progress_counts {
    size_t all, done, running, failed, cached;
    double left_s; /* negative: not known yet */
};
struct progress progress_to(FILE *to);
/* Rewrites the terminal's line; elsewhere does nothing. */
void progress_show(struct progress *p, const struct progress_counts *counts);
/* Says that a job has ended: with an error, or well if error is NULL. */
void progress_ended(struct progress *p, const struct progress_counts *counts, const char *name,
                    const char *error, double wall_time_s);
/* Erases the terminal's line, before something else is written. */
void progress_end(struct progress *p);
#endif
