/* disk.h - a disk: a queue of accesses, served in the order they came.
 *
 *   access  =  seek  +  half a turn  +  bytes at the disk's rate
 *   seek    =  0 within a cylinder; over d cylinders  track + (average - track) * sqrt(d / (cylinders / 3)),
 *              and at most the average, which is also the seek to another file
 *
 * A deterministic disk: every access, even one that begins where the last ended, waits half a turn, since the
 * platter has moved on by the time the next command comes. The disk is fast in long accesses only. A file's
 * rows follow each other from a cylinder's start on; each file has cylinders of its own. The square root is
 * how arms behave that speed up half of the way and slow down the other half; the average seek of a disk is
 * the one over a third of its cylinders.
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
    /* The access is about to start: the function may still change `row` and `rows`. Returns false if the
     * access is not wanted any more: done() follows at once with rows = 0. NULL: the access starts. */
    bool (*starts)(void *ctx, struct disk_access *a);
    void (*done)(void *ctx, struct disk_access *a, vtime now);
    void *ctx;
    struct disk_access *next; /* set by disk.c */
};

struct disk_stats {
    vtime busy;
    uint64_t accesses, seeks, rows;
};

/* address: where its events happen. */
struct disk *disk_new(const struct cfg_cfs *cfg, struct evq *q, uint32_t address);
void disk_free(struct disk *d);
/* The access must stay where it is until it is done. */
void disk_put(struct disk *d, struct disk_access *a, vtime now);
const struct disk_stats *disk_stats(const struct disk *d);
#endif
