/* disk.h - a disk: a queue of accesses, served in the order they came.
 *
 *   access  =  seek  +  half a turn  +  bytes at the disk's rate
 *   seek    =  0 within a cylinder; over d cylinders  track + (average - track) * sqrt(d / (cylinders / 3)),
 *              and at most the average, which is what it is to another file
 *
 * A deterministic disk: every access, even one that goes on where the last ended, waits half a turn, since the platter
 * has moved on by the time the next command comes. Long accesses are what makes it fast. A file's rows follow each other
 * from a cylinder's start on; each file has cylinders of its own. The square root is how arms behave that speed up half
 * of the way and slow down the other half; the average seek of a disk is the one over a third of its cylinders.
 */
#ifndef CFS_DISK_H
#define CFS_DISK_H
#include <stdbool.h>
#include "config/config.h"
#include "kernel/evq.h"

struct disk;

/* An access to `rows` rows of a file, one block each, from `row` on. */
struct disk_access {
    uint32_t file;
    uint64_t row, rows;
    /* It is about to start: may still change `row` and `rows`. False: it is not wanted any more, and done() follows at once
     * with rows = 0. NULL: start. */
    bool (*starts)(void *ctx, struct disk_access *a);
    void (*done)(void *ctx, struct disk_access *a, vtime now);
    void *ctx;
    struct disk_access *next; /* the disk's own */
};

struct disk_stats {
    vtime busy;
    uint64_t accesses, seeks, rows;
};

/* place: at which its events happen. */
struct disk *disk_new(const struct cfg_cfs *cfg, struct evq *q, uint32_t place);
void disk_free(struct disk *d);
/* a must stay where it is until it is done. */
void disk_put(struct disk *d, struct disk_access *a, vtime now);
const struct disk_stats *disk_stats(const struct disk *d);
#endif
