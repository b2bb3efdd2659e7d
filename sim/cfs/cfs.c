/* cfs.c - see cfs.h: puts the file system together, and its files as a node's files (node/file.h). */
#include "cfs/cfs.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "cfs/parts.h"

uint32_t cfs_services(const struct cfg_machine *cfg)
{
    return cfg->cfs.io_nodes ? (uint32_t)cfg->cfs.io_nodes + 1 : 0;
}

static void broken(void *ctx, const struct store_file *f, int error)
{
    struct cfs *c = ctx;
    node_system_fail(c->sys, STOP_FAILED, "/cfs/%s cannot be read or written here: %s", f->path,
                     strerror(error));
}

struct cfs *cfs_new(struct node_system *sys, const char *dir, char **error)
{
    struct cfs *c = calloc(1, sizeof *c);
    if (!c)
        abort();
    c->sys = sys;
    c->cfg = &sys->cfg->cfs;
    c->store = store_new(dir, error);
    if (!c->store) {
        free(c);
        return NULL;
    }
    c->first_place = sys->topo.positions;
    c->directory = directory_new(sys->protocol, sys->q, c->first_place + (uint32_t)c->cfg->io_nodes);
    c->io = calloc(c->cfg->io_nodes, sizeof *c->io);
    struct ionode_up up = {c, cfs_answer, cfs_room, broken};
    for (uint32_t i = 0; c->io && i < c->cfg->io_nodes; i++)
        c->io[i] = ionode_new(c->cfg, sys->q, i, c->first_place + i, sys->count, &up);
    c->fs = (struct node_fs){c, cfs_fs_open, cfs_fs_unlink, cfs_fs_rename, cfs_fs_stat};
    return c;
}

void cfs_free(struct cfs *c)
{
    if (!c)
        return;
    cfs_free_ops(c);
    cfs_free_questions(c);
    unison_free(c);
    for (uint32_t i = 0; i < c->cfg->io_nodes; i++)
        ionode_free(c->io[i]);
    free(c->io);
    directory_free(c->directory);
    store_free(c->store);
    free(c);
}

const struct node_fs *cfs_fs(struct cfs *c)
{
    return &c->fs;
}

vtime cfs_work(struct cfs *c, uint32_t place, vtime at, vtime t)
{
    uint32_t i = place - c->first_place;
    return i < c->cfg->io_nodes ? ionode_work(c->io[i], at, t) : directory_work(c->directory, at, t);
}

struct cfs_stats cfs_stats(const struct cfs *c)
{
    struct cfs_stats s = {.bytes_read = c->bytes_read, .bytes_written = c->bytes_written};
    s.directory = directory_served(c->directory);
    for (uint32_t i = 0; i < c->cfg->io_nodes; i++) {
        const struct ionode_stats *n = ionode_stats(c->io[i]);
        const struct disk_stats *d;
        s.reads += n->reads, s.writes += n->writes, s.hits += n->hits;
        for (uint32_t k = 0; (d = ionode_disk_stats(c->io[i], k)); k++) {
            s.disk_accesses += d->accesses, s.disk_seeks += d->seeks, s.disk_rows += d->rows;
            s.disk_busy = vt_max(s.disk_busy, d->busy);
        }
    }
    return s;
}

/* --- as a node's file --- */

struct cfs_file *cfs_file_of(struct node_file *f)
{
    return f->class == &CFS_FILE ? (struct cfs_file *)f : NULL;
}

const char *cfs_name(const struct cfs_file *f)
{
    return f->store->path;
}

/* A read or write from beginning to end. */
static ssize_t move(struct node_file *base, bool write, const struct iovec *part)
{
    struct cfs_op *op = cfs_start((struct cfs_file *)base, write, -1, part, 1);
    if (!op)
        return -1;
    cfs_wait(base->node, op);
    return cfs_end(op);
}

static ssize_t read_file(struct node_file *f, void *buf, size_t bytes)
{
    return move(f, false, &(struct iovec){buf, bytes});
}

static ssize_t write_file(struct node_file *f, const void *buf, size_t bytes)
{
    return move(f, true, &(struct iovec){(void *)(uintptr_t)buf, bytes});
}

static int64_t seek_file(struct node_file *f, int64_t offset, int whence)
{
    return cfs_seek((struct cfs_file *)f, offset, whence);
}

static int close_file(struct node_file *base)
{
    struct cfs_file *f = (struct cfs_file *)base;
    if (f->mode != MODE_OWN)
        modes_leave(&f->store->modes, f->mode);
    store_release(f->store);
    free(f);
    return 0;
}

const struct node_file_class CFS_FILE = {.simulated = true,
                                         .read = read_file,
                                         .write = write_file,
                                         .seek = seek_file,
                                         .stat = cfs_fstat,
                                         .truncate = cfs_truncate,
                                         .close = close_file};
