/* disk.h - a disk: a queue of accesses, served in the order they came.
 *
 *   access  =  seek, unless it begins in the cylinder where the last one ended  +  half a turn  +  bytes at the disk's rate
 *
 * A deterministic disk: every seek takes the average, and every access, even one that goes on where the last ended,
 * waits half a turn, since the platter has moved on by the time the next command comes. Long accesses are what makes it
 * fast. A file's rows follow each other on the disk from a cylinder's start on; each file has cylinders of its own.
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
    /* It is about to start: may still change `rows`. False: it is not wanted any more, and done() follows at once
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
