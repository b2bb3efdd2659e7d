/* progress.h - tells a person how a pool is getting on: one live line on a terminal, a line per job
 * elsewhere. */
#ifndef LAB_JOBS_PROGRESS_H
#define LAB_JOBS_PROGRESS_H
#include "lab/jobs/process_pool.h"

#include <stdio.h>

struct progress {
    FILE *to;
    bool live; /* a terminal: one line, rewritten */
};

/* A watcher that writes to `to`. p must live as long as the watcher is used. */
struct pool_watcher progress_watcher(struct progress *p, FILE *to);
/* The same for who counts by himself. */
struct progress_counts {
    size_t all, done, running, failed, cached;
    double left_s; /* negative: not known yet */
};
struct progress progress_to(FILE *to);
/* The live line, where there is one. */
void progress_show(struct progress *p, const struct progress_counts *counts);
/* One has ended: well if error is NULL. */
void progress_ended(struct progress *p, const struct progress_counts *counts, const char *name,
                    const char *error, double wall_time_s);
/* Wipes the live line, before something else is written. */
void progress_end(struct progress *p);
#endif
