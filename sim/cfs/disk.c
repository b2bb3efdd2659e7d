/* disk.c - see disk.h. */
#include "cfs/disk.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

struct disk {
    const struct cfg_cfs *cfg;
    struct evq *q;
    uint32_t address;
    struct disk_access *first, *last; /* waiting */
    struct disk_access *now;          /* being served; NULL: the disk is idle */
    bool moved;                       /* the head is at a cylinder of a file */
    uint32_t file;
    uint64_t cylinder;
    struct disk_stats stats;
};

struct disk *disk_new(const struct cfg_cfs *cfg, struct evq *q, uint32_t address)
{
    struct disk *d = xcalloc(1, sizeof *d);
    d->cfg = cfg, d->q = q, d->address = address;
    return d;
}

void disk_free(struct disk *d)
{
    free(d);
}

/* The time in which the head moves to a cylinder of a file. */
static vtime seek_time(const struct disk *d, uint32_t file, uint64_t cylinder)
{
    const struct cfg_cfs *c = d->cfg;
    if (!d->moved || d->file != file)
        return c->seek_ps;
    uint64_t distance = d->cylinder > cylinder ? d->cylinder - cylinder : cylinder - d->cylinder;
    if (distance == 0)
        return 0;
    double part = sqrt(3 * (double)distance / (double)c->cylinders);
    return vt_min(c->seek_ps, c->seek_track_ps + (vtime)((double)(c->seek_ps - c->seek_track_ps) * part));
}

static vtime service_time(struct disk *d, const struct disk_access *a)
{
    uint64_t per_cylinder = d->cfg->cylinder_blocks;
    vtime seek = seek_time(d, a->file, a->row / per_cylinder);
    d->moved = true, d->file = a->file, d->cylinder = (a->row + a->rows - 1) / per_cylinder;
    d->stats.seeks += seek > 0;
    return seek + d->cfg->rotation_ps + a->rows * d->cfg->block_bytes * d->cfg->disk_ps_per_byte;
}

static void finish(void *ctx, void *arg, vtime now);

/* Starts the first access in the queue that is still wanted. */
static void serve(struct disk *d, vtime now)
{
    while (!d->now && d->first) {
        struct disk_access *a = d->first;
        d->first = a->next;
        if (!d->first)
            d->last = NULL;
        if (a->starts && !a->starts(a->ctx, a)) {
            a->rows = 0;
            a->done(a->ctx, a, now);
            continue;
        }
        vtime t = service_time(d, a);
        d->now = a;
        d->stats.busy += t;
        d->stats.accesses++;
        d->stats.rows += a->rows;
        evq_put(d->q, now + t, d->address, finish, d, a);
    }
}

static void finish(void *ctx, void *arg, vtime now)
{
    struct disk *d = ctx;
    struct disk_access *a = arg;
    assert(d->now == a);
    d->now = NULL;
    a->done(a->ctx, a, now);
    serve(d, now);
}

void disk_put(struct disk *d, struct disk_access *a, vtime now)
{
    a->next = NULL;
    if (d->last)
        d->last->next = a;
    else
        d->first = a;
    d->last = a;
    serve(d, now);
}

const struct disk_stats *disk_stats(const struct disk *d)
{
    return &d->stats;
}
