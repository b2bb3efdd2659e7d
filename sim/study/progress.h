/* progress.h - tells a person how a pool is getting on: one live line on a terminal, a line per job
 * elsewhere. */
#ifndef STUDY_PROGRESS_H
#define STUDY_PROGRESS_H
#include "study/pool.h"

#include <stdio.h>

struct progress {
    FILE *to;
    bool live; /* a terminal: one line, rewritten */
};

/* A watcher that writes to `to`. p must live as long as the watcher is used. */
struct pool_watcher progress_watcher(struct progress *p, FILE *to);
/* Wipes the live line, before something else is written. */
void progress_end(struct progress *p);
#endif
