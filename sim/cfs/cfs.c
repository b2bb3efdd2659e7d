/* cfs.c - see cfs.h: puts the file system together. */
#include "cfs/cfs.h"
#include <stdlib.h>
#include <string.h>
#include "cfs/cfs_state.h"
#include "kernel/xalloc.h"
#include "os/first_failure.h"

uint32_t cfs_services(const struct cfg_machine *cfg)
{
    return cfg->cfs.io_nodes ? (uint32_t)cfg->cfs.io_nodes + 1 : 0;
}

static void broken(void *ctx, const struct store_file *f, int error)
{
    struct cfs *c = ctx;
    node_system_fail(c->sys, STOP_FAILED, c->sys->schedule.present,
                     "/cfs/%s cannot be read or written here: %s", f->path, strerror(error));
}

struct cfs *cfs_new(struct node_system *sys, const char *dir, char **error)
{
    struct cfs *c = xcalloc(1, sizeof *c);
    c->sys = sys;
    c->cfg = &sys->cfg->cfs;
    c->store = store_new(dir, error);
    if (!c->store) {
        free(c);
        return NULL;
    }
    c->first_address = sys->topo.positions;
    c->directory =
        directory_new(sys->schedule.protocol, sys->schedule.q, c->first_address + (uint32_t)c->cfg->io_nodes);
    c->io = xcalloc(c->cfg->io_nodes, sizeof *c->io);
    struct ionode_up up = {c, cfs_answer, cfs_room, broken};
    for (uint32_t i = 0; i < c->cfg->io_nodes; i++)
        c->io[i] = ionode_new(c->cfg, sys->schedule.q, i, c->first_address + i, sys->count, &up);
    c->fs = (struct node_fs){c, cfs_open, cfs_unlink, cfs_rename, cfs_stat_path, cfs_names};
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

vtime cfs_work(struct cfs *c, uint32_t address, vtime at, vtime t)
{
    uint32_t i = address - c->first_address;
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
