/* ionode.c - see ionode.h. */
#include "cfs/ionode.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include "cfs/block_cache.h"
#include "kernel/xalloc.h"

/* The blocks of a file on a disk that were read last: by node, a block plus 1; 0: none. */
struct last_read {
    uint32_t file; /* its id then */
    uint64_t *block;
};

struct io_disk {
    struct disk *disk;
    struct last_read *last; /* by the file's slot */
    uint32_t files;
};

struct ionode {
    const struct cfg_cfs *cfg;
    struct evq *q;
    uint32_t index, address, nodes;
    struct ionode_up up;
    vtime free_at; /* processor */
    struct cache *cache;
    struct io_disk *disks;
    uint32_t disk_count;
    struct transfer *transfers;                /* queued at the disks, or under way */
    struct io_request *stalled, **stalled_end; /* wait for an idle cache block */
    struct ionode_stats stats;
};

/* An access to disk: rows of one file, whose blocks are `stride` apart. */
struct transfer {
    struct disk_access access;
    struct ionode *io;
    struct io_disk *disk;
    uint64_t block;
    uint32_t stride;
    struct transfer *next, **link; /* the I/O node's */
};

/* --- making and freeing --- */

static void transfer_free(struct transfer *t)
{
    if (t->next)
        t->next->link = t->link;
    *t->link = t->next;
    free(t);
}

struct ionode *ionode_new(const struct cfg_cfs *cfg, struct evq *q, uint32_t index, uint32_t address,
                          uint32_t nodes, const struct ionode_up *up)
{
    struct ionode *io = xcalloc(1, sizeof *io);
    uint32_t disks = (uint32_t)((cfg->disks - index + cfg->io_nodes - 1) / cfg->io_nodes);
    io->disks = xcalloc(disks, sizeof *io->disks);
    io->cfg = cfg, io->q = q, io->index = index, io->address = address, io->nodes = nodes, io->up = *up;
    io->cache = cache_new(cfg->cache_blocks);
    io->stalled_end = &io->stalled;
    io->disk_count = disks;
    for (uint32_t i = 0; i < disks; i++)
        io->disks[i].disk = disk_new(cfg, q, address);
    return io;
}

void ionode_free(struct ionode *io)
{
    if (!io)
        return;
    for (uint32_t i = 0; i < io->disk_count; i++) {
        for (uint32_t f = 0; f < io->disks[i].files; f++)
            free(io->disks[i].last[f].block);
        free(io->disks[i].last);
        disk_free(io->disks[i].disk);
    }
    free(io->disks);
    while (io->transfers) /* if the machine stops while disks are busy */
        transfer_free(io->transfers);
    cache_free(io->cache);
    free(io);
}

vtime ionode_work(struct ionode *io, vtime at, vtime t)
{
    io->stats.busy += t;
    return io->free_at = vt_max(at, io->free_at) + t;
}

static struct io_disk *disk_of(struct ionode *io, const struct io_request *r)
{
    return &io->disks[r->piece.disk / io->cfg->io_nodes];
}

static struct cache_block *block_of(struct ionode *io, const struct io_request *r)
{
    return cache_find(io->cache, r->file_id, r->piece.block);
}

static void append(struct io_request ***end, struct io_request *r)
{
    r->next = NULL;
    **end = r;
    *end = &r->next;
}

/* --- answering --- */

static void copied_out(void *ctx, void *arg, vtime now)
{
    struct ionode *io = ctx;
    struct io_request *r = arg;
    uint64_t at = r->piece.block * io->cfg->block_bytes + r->piece.offset;
    int error = store_read(r->file, at, r->data, r->piece.bytes);
    if (error)
        io->up.broken(io->up.ctx, r->file, error);
    io->up.answer(io->up.ctx, r, now);
}

static void answer_read(struct ionode *io, struct io_request *r, vtime now)
{
    vtime ready = ionode_work(io, now, r->piece.bytes * io->cfg->copy_ps_per_byte);
    evq_put(io->q, ready, io->address, copied_out, io, r);
}

/* --- disk --- */

static void serve_stalled(struct ionode *io, vtime now);
static void put_write(struct ionode *io, struct io_disk *d, const struct cache_block *b, uint32_t stride,
                      vtime now);

static struct cache_block *nth(const struct transfer *t, uint64_t k)
{
    return cache_find(t->io->cache, t->access.file, t->block + k * t->stride);
}

/* A block has come from or gone to disk: it is clean, unless it was written meanwhile. */
static void block_transferred(struct transfer *t, struct cache_block *b, vtime now)
{
    assert(b->state == CACHE_READING || b->state == CACHE_WRITING);
    struct io_request *r = b->waiting;
    b->waiting = NULL, b->waiting_end = &b->waiting;
    b->state = b->dirty_again ? CACHE_DIRTY : CACHE_CLEAN;
    b->dirty_again = false;
    cache_touch(t->io->cache, b);
    if (b->state == CACHE_DIRTY)
        put_write(t->io, t->disk, b, t->stride, now);
    for (struct io_request *next; r; r = next) {
        next = r->next;
        answer_read(t->io, r, now);
    }
}

static void transferred(void *ctx, struct disk_access *a, vtime now)
{
    struct transfer *t = ctx;
    struct ionode *io = t->io;
    uint64_t rows = a->rows;
    for (uint64_t k = 0; k < rows; k++)
        block_transferred(t, nth(t, k), now);
    transfer_free(t);
    if (rows > 0)
        serve_stalled(io, now);
}

static struct transfer *transfer_new(struct ionode *io, struct io_disk *d, uint32_t file, uint64_t block,
                                     uint32_t stride)
{
    struct transfer *t = xcalloc(1, sizeof *t);
    *t = (struct transfer){.io = io, .disk = d, .block = block, .stride = stride};
    t->next = io->transfers, t->link = &io->transfers;
    if (t->next)
        t->next->link = &t->next;
    io->transfers = t;
    t->access =
        (struct disk_access){.file = file, .row = block / stride, .rows = 1, .done = transferred, .ctx = t};
    return t;
}

/* Adds a row, before the first or behind the last. */
static void extend(struct transfer *t, bool before)
{
    t->block -= before ? t->stride : 0;
    t->access.row -= before;
    t->access.rows++;
}

static struct cache_block *behind(const struct transfer *t)
{
    return nth(t, t->access.rows);
}

static struct cache_block *before(const struct transfer *t)
{
    return t->access.row > 0 ? cache_find(t->io->cache, t->access.file, t->block - t->stride) : NULL;
}

static bool is_dirty(const struct cache_block *b)
{
    return b && b->state == CACHE_DIRTY;
}

/* The disk is about to start a write: the dirty blocks around it are written with it. Returns false if the
 * block has been written with another. */
static bool gather(void *ctx, struct disk_access *a)
{
    struct transfer *t = ctx;
    uint64_t most = t->io->cfg->write_cluster_blocks;
    if (!is_dirty(nth(t, 0)))
        return false;
    while (a->rows < most && is_dirty(before(t)))
        extend(t, true);
    while (a->rows < most && is_dirty(behind(t)))
        extend(t, false);
    for (uint64_t k = 0; k < a->rows; k++)
        nth(t, k)->state = CACHE_WRITING;
    return true;
}

static void put_write(struct ionode *io, struct io_disk *d, const struct cache_block *b, uint32_t stride,
                      vtime now)
{
    struct transfer *t = transfer_new(io, d, b->file, b->number, stride);
    t->access.starts = gather;
    disk_put(d->disk, &t->access, now);
}

/* --- reading --- */

/* Does the request continue what its node, or any node, has read on that disk? */
static bool sequential(struct ionode *io, const struct io_request *r)
{
    const struct io_disk *d = disk_of(io, r);
    uint64_t before = r->piece.block - r->stride;
    if (r->shared || r->piece.row == 0)
        return true;
    const struct last_read *last = r->file->slot < d->files ? &d->last[r->file->slot] : NULL;
    if (last && last->block && last->file == r->file_id && last->block[r->node] == before + 1)
        return true;
    return cache_find(io->cache, r->file_id, before);
}

static void remember(struct ionode *io, const struct io_request *r)
{
    struct io_disk *d = disk_of(io, r);
    if (r->file->slot >= d->files) {
        uint32_t files = r->file->slot + 16;
        d->last = xreallocarray(d->last, files, sizeof *d->last);
        memset(&d->last[d->files], 0, (files - d->files) * sizeof *d->last);
        d->files = files;
    }
    struct last_read *last = &d->last[r->file->slot];
    if (!last->block)
        last->block = xcalloc(io->nodes, sizeof *last->block);
    if (last->file < r->file_id) { /* another file's, or the file's before it was cut */
        memset(last->block, 0, io->nodes * sizeof *last->block);
        last->file = r->file_id;
    }
    if (last->file == r->file_id)
        last->block[r->node] = r->piece.block + 1;
}

/* Reserves a block for reading if it is part of the file, is not in the cache, and there is an idle one for
 * it. */
static bool reserve_row(struct ionode *io, const struct io_request *r, uint64_t block)
{
    if (block * io->cfg->block_bytes >= r->file->size || cache_find(io->cache, r->file_id, block))
        return false;
    struct cache_block *b = cache_take(io->cache, r->file_id, block);
    if (b)
        b->state = CACHE_READING;
    return b;
}

/* Brings a RESERVED block from disk, and those blocks of its group of `group` rows that are missing next to
 * it. */
static void fetch(struct ionode *io, struct io_request *r, struct cache_block *b, uint64_t group, vtime now)
{
    struct io_disk *d = disk_of(io, r);
    struct transfer *t = transfer_new(io, d, b->file, b->number, r->stride);
    uint64_t first = t->access.row / group * group, end = first + group;
    b->state = CACHE_READING;
    while (t->access.row + t->access.rows < end && reserve_row(io, r, t->block + t->access.rows * t->stride))
        extend(t, false);
    while (t->access.row > first && reserve_row(io, r, t->block - t->stride))
        extend(t, true);
    disk_put(d->disk, &t->access, now);
}

/* Returns false if there is no idle block. */
static bool read_block(struct ionode *io, struct io_request *r, vtime now)
{
    struct cache_block *b = block_of(io, r);
    if (b && b->state == CACHE_RESERVED) {
        /* The data of a write are on their way: the rest of the block is read first. */
        append(&b->waiting_end, r);
        fetch(io, r, b, 1, now);
    } else if (b && b->state != CACHE_READING) {
        io->stats.hits++;
        cache_touch(io->cache, b);
        answer_read(io, r, now);
    } else if (b) {
        append(&b->waiting_end, r);
    } else {
        bool ahead = sequential(io, r);
        if (!(b = cache_take(io->cache, r->file_id, r->piece.block)))
            return false;
        append(&b->waiting_end, r);
        fetch(io, r, b, ahead ? io->cfg->read_ahead_blocks : 1, now);
    }
    remember(io, r);
    return true;
}

/* --- writing --- */

static bool hold(struct ionode *io, struct io_request *r)
{
    struct cache_block *b = block_of(io, r);
    if (!b && !(b = cache_take(io->cache, r->file_id, r->piece.block)))
        return false;
    b->holds++;
    r->held = true;
    cache_touch(io->cache, b);
    return true;
}

/* Is there more of the block on disk than is being written? */
static bool is_part(const struct ionode *io, const struct io_request *r)
{
    uint64_t start = r->piece.block * io->cfg->block_bytes;
    uint64_t old = r->file->size > start ? r->file->size - start : 0;
    return old > 0 && (r->piece.offset > 0 || r->piece.bytes < old) && r->piece.bytes < io->cfg->block_bytes;
}

/* The data are here, and a block is held for them. */
static void take_data(struct ionode *io, struct io_request *r, vtime now)
{
    struct cache_block *b = block_of(io, r);
    bool part = is_part(io, r);
    int error = store_write(r->file, r->piece.block * io->cfg->block_bytes + r->piece.offset, r->data,
                            r->piece.bytes);
    if (error)
        io->up.broken(io->up.ctx, r->file, error);
    assert(b->holds > 0);
    b->holds--;
    if (b->state == CACHE_RESERVED && part) {
        b->dirty_again = true; /* the rest of the block is read first */
        fetch(io, r, b, 1, now);
    } else if (b->state == CACHE_RESERVED || b->state == CACHE_CLEAN) {
        b->state = CACHE_DIRTY;
        cache_touch(io->cache, b);
        put_write(io, disk_of(io, r), b, r->stride, now);
    } else if (b->state == CACHE_READING || b->state == CACHE_WRITING) {
        b->dirty_again = true;
    }
    io->up.answer(io->up.ctx, r, now);
}

/* --- requests --- */

/* Returns false if the request has to wait for an idle block. */
static bool admit(struct ionode *io, struct io_request *r, vtime now)
{
    if (!r->write)
        return read_block(io, r, now);
    if (!r->held && !hold(io, r))
        return false;
    if (r->here)
        take_data(io, r, now);
    return true;
}

static void stall(struct ionode *io, struct io_request *r)
{
    append(&io->stalled_end, r);
}

static void serve_stalled(struct ionode *io, vtime now)
{
    while (io->stalled) {
        struct io_request *r = io->stalled, *next = r->next;
        bool asked = !r->here;
        /* off the list first: admit() may call this function */
        io->stalled = next;
        if (!next)
            io->stalled_end = &io->stalled;
        if (!admit(io, r, now)) {
            r->next = io->stalled;
            if (!io->stalled)
                io->stalled_end = &r->next;
            io->stalled = r;
            return;
        }
        if (asked)
            io->up.room(io->up.ctx, r, now);
    }
}

bool ionode_reserve(struct ionode *io, struct io_request *r, vtime now)
{
    r->file_id = r->file->id, r->held = r->here = false;
    if (!io->stalled && admit(io, r, now))
        return true;
    stall(io, r);
    return false;
}

static void admit_or_stall(void *ctx, void *arg, vtime now)
{
    struct ionode *io = ctx;
    struct io_request *r = arg;
    bool must_queue = io->stalled && !(r->write ? r->held : (bool)block_of(io, r));
    if (must_queue || !admit(io, r, now))
        stall(io, r);
}

void ionode_request(struct ionode *io, struct io_request *r, vtime at)
{
    if (!r->held)
        r->file_id = r->file->id;
    r->here = true;
    io->stats.reads += !r->write;
    io->stats.writes += r->write;
    vtime copy = r->write ? r->piece.bytes * io->cfg->copy_ps_per_byte : 0;
    vtime ready = ionode_work(io, at, io->cfg->request_ps + copy);
    evq_put(io->q, ready, io->address, admit_or_stall, io, r);
}

const struct ionode_stats *ionode_stats(const struct ionode *io)
{
    return &io->stats;
}

const struct disk_stats *ionode_disk_stats(const struct ionode *io, uint32_t which)
{
    return which < io->disk_count ? disk_stats(io->disks[which].disk) : NULL;
}
