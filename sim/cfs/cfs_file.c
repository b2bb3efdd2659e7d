/* cfs_file.c - see cfs_file.h. */
#include "cfs/cfs_file.h"
#include <stdlib.h>
#include "cfs/cfs_state.h"
#include "cfs/directory_calls.h"
#include "cfs/operation.h"
#include "kernel/xalloc.h"

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

static const struct node_file_class CLASS = {.simulated = true,
                                             .read = read_file,
                                             .write = write_file,
                                             .seek = seek_file,
                                             .stat = cfs_fstat,
                                             .truncate = cfs_truncate,
                                             .close = close_file};

struct node_file *cfs_open(void *ctx, struct node *n, const char *path, int flags, mode_t permissions)
{
    struct cfs *c = ctx;
    struct store_file *store = cfs_ask_open(c, n, path, flags, permissions);
    if (!store)
        return NULL;
    struct cfs_file *f = xcalloc(1, sizeof *f);
    *f = (struct cfs_file){.base = {.class = &CLASS, .node = n}, .cfs = c, .store = store, .flags = flags};
    return &f->base;
}

struct cfs_file *cfs_file_of(struct node_file *f)
{
    return f->class == &CLASS ? (struct cfs_file *)f : NULL;
}
