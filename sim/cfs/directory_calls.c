/* directory_calls.c - see directory_calls.h. Each call sends a request to the directory, waits for its turn
 * there, and gets an answer. */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include "cfs/cfs_state.h"
#include "cfs/directory_calls.h"
#include "guest/libc/host_errno.h"
#include "kernel/xalloc.h"
#include "lp/engine.h"
#include "os/first_failure.h"
#include "os/front.h"
#include "os/gate.h"

/* A request to the directory, and its answer. A request under way refers to nothing in its program's memory,
 * for the program may be killed: ask() makes a copy of the request and of all that it points to. */
struct question {
    struct dir_request request; /* first */
    struct cfs *cfs;
    struct node *node;
    int (*work)(struct question *q); /* at the directory: 0, or errno */
    const char *path, *to;
    int flags;
    mode_t permissions;
    struct store_file *store;
    struct stat st;
    char *names;           /* of the answer, for free() */
    struct cfs_file *file; /* an open one of the program's; NULL: the request is about a name */
    uint64_t number;
    const uint32_t *disks; /* `number` of them */
    int error;
    bool answered;
    vtime complete;
    struct question *next, **link; /* cfs.questions */
};

static struct question *keep(const struct question *q)
{
    struct question *kept = xmalloc(sizeof *kept);
    *kept = *q;
    kept->path = q->path ? xstrdup(q->path) : NULL;
    kept->to = q->to ? xstrdup(q->to) : NULL;
    if (q->disks) {
        uint32_t *disks = xcalloc(q->number + 1, sizeof *disks);
        kept->disks = memcpy(disks, q->disks, q->number * sizeof *disks);
    }
    struct cfs *c = q->cfs;
    kept->next = c->questions, kept->link = &c->questions;
    if (kept->next)
        kept->next->link = &kept->next;
    return c->questions = kept;
}

static void drop(struct question *q)
{
    if (q->next)
        q->next->link = q->link;
    *q->link = q->next;
    free((void *)(uintptr_t)q->path);
    free((void *)(uintptr_t)q->to);
    free((void *)(uintptr_t)q->disks);
    free(q->names);
    free(q);
}

void cfs_free_questions(struct cfs *c)
{
    while (c->questions)
        drop(c->questions);
}

/* A program's files are closed at its end: a request about one of them is then void. */
static bool serve(struct dir_request *r, vtime now)
{
    struct question *q = (struct question *)r;
    (void)now;
    if (!q->file || q->node->lp.state != LP_ENDED)
        q->error = q->work(q);
    if (store_failure(q->cfs->store))
        node_system_fail(q->cfs->sys, STOP_FAILED, q->cfs->sys->schedule.present, "the files of /cfs: %s",
                         store_failure(q->cfs->store));
    return true;
}

static void answered(struct dir_request *r, vtime at, vtime now)
{
    struct question *q = (struct question *)r;
    (void)now;
    q->answered = true;
    q->complete = at;
    if (q->node->lp.state == LP_ENDED)
        drop(q); /* nobody waits for the answer */
    else
        lp_wake(&q->node->lp, at);
}

static bool is_answered(struct node *n, void *arg)
{
    const struct question *q = arg;
    return q->answered && q->complete <= node_now(n);
}

/* 0, or -1 with errno, which a call that succeeds leaves as it was. */
static int answer(int error)
{
    if (error)
        node_set_errno(error);
    return error ? -1 : 0;
}

static int ask(struct cfs *c, struct node *n, struct question *q, vtime takes)
{
    q->cfs = c;
    q->node = n;
    q->request = (struct dir_request){.node = n->id, .takes = takes, .serve = serve, .answered = answered};
    node_spend(n, n->sys->cfg->call_ps + directory_ask_time(c->directory));
    struct question *kept = keep(q);
    directory_ask(c->directory, &kept->request, node_now(n));
    node_order(n);
    node_wait(n, is_answered, kept);
    q->error = kept->error, q->number = kept->number, q->store = kept->store, q->st = kept->st;
    q->names = kept->names;
    kept->names = NULL; /* the caller's now */
    drop(kept);
    return answer(q->error);
}

/* --- names --- */

static int do_open(struct question *q)
{
    return store_open(q->cfs->store, q->path, q->flags, q->permissions, &q->store);
}

struct store_file *cfs_ask_open(struct cfs *c, struct node *n, const char *path, int flags,
                                mode_t permissions)
{
    struct question q = {.work = do_open, .path = path, .flags = flags, .permissions = permissions};
    if (ask(c, n, &q, c->cfg->open_ps))
        return NULL;
    if (!q.store->volumes)
        q.store->volume_count = (uint32_t)c->cfg->disks;
    return q.store;
}

static int do_unlink(struct question *q)
{
    return store_unlink(q->cfs->store, q->path);
}

int cfs_unlink(void *ctx, struct node *n, const char *path)
{
    struct cfs *c = ctx;
    return ask(c, n, &(struct question){.work = do_unlink, .path = path}, c->cfg->open_ps);
}

static int do_rename(struct question *q)
{
    return store_rename(q->cfs->store, q->path, q->to);
}

int cfs_rename(void *ctx, struct node *n, const char *from, const char *to)
{
    struct cfs *c = ctx;
    return ask(c, n, &(struct question){.work = do_rename, .path = from, .to = to}, c->cfg->open_ps);
}

/* Reduces a file's state to what the simulated machine knows: not when, where and how this computer keeps the
 * file, nor what its user's umask leaves to others. */
static int own_stat(const struct cfs *c, struct stat *st, int error)
{
    if (error)
        return error;
    bool folder = S_ISDIR(st->st_mode);
    *st = (struct stat){.st_ino = st->st_ino,
                        .st_mode = st->st_mode & (S_IFMT | S_IRWXU),
                        .st_nlink = folder ? 2 : st->st_nlink,
                        .st_size = folder ? 0 : st->st_size};
    st->st_dev = (dev_t)-1; /* no device of this computer */
    st->st_blksize = (blksize_t)c->cfg->block_bytes;
    st->st_blocks = (st->st_size + 511) / 512;
    return 0;
}

static int do_stat(struct question *q)
{
    return own_stat(q->cfs, &q->st, store_stat(q->cfs->store, q->path, &q->st));
}

int cfs_stat_path(void *ctx, struct node *n, const char *path, struct stat *st)
{
    struct cfs *c = ctx;
    struct question q = {.work = do_stat, .path = path};
    int r = ask(c, n, &q, c->cfg->open_ps);
    if (r == 0)
        *st = q.st;
    return r;
}

static int do_names(struct question *q)
{
    return store_names(q->cfs->store, q->path, &q->names);
}

char *cfs_names(void *ctx, struct node *n, const char *path)
{
    struct cfs *c = ctx;
    struct question q = {.work = do_names, .path = path};
    return ask(c, n, &q, c->cfg->open_ps) ? NULL : q.names;
}

/* --- sizes --- */

static int do_fstat(struct question *q)
{
    return own_stat(q->cfs, &q->st, store_fstat(q->file->store, &q->st));
}

int cfs_fstat(struct node_file *base, struct stat *st)
{
    struct cfs_file *f = (struct cfs_file *)base;
    struct question q = {.work = do_fstat, .file = f};
    int r = ask(f->cfs, base->node, &q, f->cfs->cfg->pointer_ps);
    if (r == 0)
        *st = q.st;
    return r;
}

static bool may_write(const struct cfs_file *f)
{
    return (f->flags & O_ACCMODE) != O_RDONLY;
}

static int do_grow(struct question *q)
{
    int error = store_grow(q->file->store, q->number);
    q->number = q->file->store->size;
    return error;
}

int64_t cfs_grow(struct cfs_file *f, uint64_t size)
{
    struct question q = {.work = do_grow, .file = f, .number = size};
    if (!may_write(f))
        return answer(EBADF);
    return ask(f->cfs, f->base.node, &q, f->cfs->cfg->pointer_ps) ? -1 : (int64_t)q.number;
}

static int do_cut(struct question *q)
{
    return store_cut(q->file->store, q->number);
}

int cfs_truncate(struct node_file *base, int64_t size)
{
    struct cfs_file *f = (struct cfs_file *)base;
    if (!may_write(f))
        return answer(EINVAL);
    struct question q = {.work = do_cut, .file = f, .number = (uint64_t)size};
    return ask(f->cfs, base->node, &q, f->cfs->cfg->pointer_ps);
}

static int do_restrict(struct question *q)
{
    struct store_file *f = q->file->store;
    uint32_t count = (uint32_t)q->number;
    bool same = count == f->volume_count;
    for (uint32_t i = 0; i < count; i++) {
        if (q->disks[i] >= q->cfs->cfg->disks)
            return EINVAL;
        same = same && (f->volumes ? f->volumes[i] : i) == q->disks[i];
    }
    if (same)
        return 0;
    if (f->size > 0 || count == 0)
        return EINVAL;
    uint32_t *volumes = xmalloc(count * sizeof *volumes);
    for (uint32_t i = 0; i < count; i++)
        volumes[i] = q->disks[i];
    free(f->volumes);
    f->volumes = volumes;
    f->volume_count = count;
    return 0;
}

void cfs_disks(const struct cfs_file *f, int *count, int *first)
{
    *count = (int)f->store->volume_count;
    *first = f->store->volumes ? (int)f->store->volumes[0] : 0;
}

int cfs_restrict(struct cfs_file *f, const uint32_t *disks, uint32_t count)
{
    struct question q = {.work = do_restrict, .file = f, .disks = disks, .number = count};
    return ask(f->cfs, f->base.node, &q, f->cfs->cfg->pointer_ps);
}

/* --- pointers and modes --- */

/* Where the file's pointer is, or the node's own. In mode 3 all nodes make the same seeks: each has its own
 * in mind, whether or not the others have made theirs. */
static uint64_t pointer(const struct cfs_file *f)
{
    if (f->mode == MODE_RECORDS)
        return cfs_has_sought(f) ? f->at : modes_round_from(cfs_group(f), f->round, f->cfs->sys->count);
    return cfs_own_pointer(f) ? f->at : cfs_group(f)->at;
}

static void set_pointer(struct cfs_file *f, uint64_t at)
{
    if (f->mode == MODE_FIRST_COME || f->mode == MODE_ORDERED)
        cfs_group(f)->at = at;
    else
        f->at = at;
    if (f->mode != MODE_RECORDS)
        return;
    f->sought = f->round + 1;
    modes_set_round(cfs_group(f), f->round, f->cfs->sys->count, at);
}

static int do_seek(struct question *q)
{
    int64_t from = q->flags == SEEK_SET   ? 0
                   : q->flags == SEEK_CUR ? (int64_t)pointer(q->file)
                                          : (int64_t)q->file->store->size;
    int64_t at;
    if (q->flags < SEEK_SET || q->flags > SEEK_END)
        return EINVAL;
    if (__builtin_add_overflow(from, (int64_t)q->number, &at))
        return EOVERFLOW;
    if (at < 0)
        return EINVAL;
    q->number = (uint64_t)at;
    if (q->number != pointer(q->file))
        set_pointer(q->file, q->number);
    return 0;
}

/* Only the directory knows sizes and shared pointers; a node's own pointer needs no message. */
int64_t cfs_seek(struct cfs_file *f, int64_t offset, int whence)
{
    struct node *n = f->base.node;
    struct question q = {.work = do_seek, .file = f, .flags = whence, .number = (uint64_t)offset};
    if (whence == SEEK_END || f->mode == MODE_FIRST_COME || f->mode == MODE_ORDERED)
        return ask(f->cfs, n, &q, f->cfs->cfg->pointer_ps) ? -1 : (int64_t)q.number;
    node_spend(n, n->sys->cfg->call_ps);
    node_order(n);
    return answer(do_seek(&q)) ? -1 : (int64_t)q.number;
}

int cfs_mode(const struct cfs_file *f)
{
    return f->mode;
}

static int do_set_mode(struct question *q)
{
    struct cfs_file *f = q->file;
    struct modes *m = &f->store->modes;
    f->at = pointer(f);
    if (f->mode != MODE_OWN)
        modes_leave(m, f->mode);
    f->mode = q->flags;
    f->round = f->sought = 0;
    if (f->mode != MODE_OWN)
        modes_join(m, f->mode, f->at);
    f->generation = cfs_group(f)->generation;
    return 0;
}

int cfs_set_mode(struct cfs_file *f, int mode)
{
    struct question q = {.work = do_set_mode, .file = f, .flags = mode};
    return ask(f->cfs, f->base.node, &q, f->cfs->cfg->pointer_ps);
}

bool cfs_at_end(const struct cfs_file *f)
{
    return pointer(f) >= f->store->size;
}
