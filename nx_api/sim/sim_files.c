/* sim_files.c - the NX calls on files in the simulator. On files of the host's they work, too: at once, in no
 * time, with an I/O mode of 0. */
#include <errno.h>
#include <stddef.h>
#include <string.h>
#include "cfs/cfs.h"
#include "guest/libc/host_errno.h"
#include "guest/libc/libc_parts.h"
#include "nx_api/calls/file_calls.h"
#include "os/asan_hooks.h"
#include "os/observer.h"

/* --- errors --- */

/* The error of errno. */
static long fail(struct node *n, const char *what)
{
    int why = node_errno();
    return node_error(n, why, "%s: %s", what, strerror(why));
}

static long fail_on(struct node *n, int fd)
{
    return fail(n, descriptor_path(n, fd));
}

/* The file of a descriptor; NULL with the error: it is not open. */
static struct node_file *file_of(int fd)
{
    struct node *n = node_self();
    struct node_file *f = descriptor_file(n, fd);
    if (!f)
        node_error(n, EBADF, "%d is not an open file", fd);
    return f;
}

/* --- reading and writing --- */

static ssize_t move_host_parts(struct node_file *f, bool write, const struct iovec *parts, int count)
{
    ssize_t moved = 0;
    for (int i = 0; i < count; i++) {
        ssize_t n = write ? f->class->write(f, parts[i].iov_base, parts[i].iov_len)
                          : f->class->read(f, parts[i].iov_base, parts[i].iov_len);
        if (n < 0)
            return -1;
        moved += n;
        if ((size_t)n < parts[i].iov_len)
            break;
    }
    return moved;
}

/* A file of the host's: moved at once. */
static ssize_t move_host(struct node_file *f, bool write, int64_t at, const struct iovec *parts, int count)
{
    int64_t before = at == AT_POINTER ? 0 : f->class->seek(f, 0, SEEK_CUR);
    if (before < 0 || (at != AT_POINTER && f->class->seek(f, at, SEEK_SET) < 0))
        return -1;
    ssize_t moved = move_host_parts(f, write, parts, count);
    if (at != AT_POINTER)
        f->class->seek(f, before, SEEK_SET);
    return moved;
}

/* Begins a movement. *op is NULL if it is complete already, with *moved bytes. */
static long start(bool write, int fd, struct node_file *f, int64_t at, const struct iovec *parts, int count,
                  struct cfs_op **op, ssize_t *moved)
{
    struct cfs_file *file = cfs_file_of(f);
    if (nx_check_parts(f->node, parts, count) < 0)
        return -1;
    for (int i = 0; i < count; i++) {
        ASAN_CALL(f->node, !write, parts[i].iov_base, parts[i].iov_len);
        ANNOUNCE(f->node, moves, !write, parts[i].iov_base, parts[i].iov_len);
    }
    *op = file ? cfs_start(file, write, at, parts, count) : NULL;
    *moved = file ? 0 : move_host(f, write, at, parts, count);
    return (file && !*op) || *moved < 0 ? fail_on(f->node, fd) : 0;
}

long nx_move(bool write, int fd, int64_t at, const struct iovec *parts, int count)
{
    struct node_file *f = file_of(fd);
    struct cfs_op *op;
    ssize_t moved;
    if (!f || start(write, fd, f, at, parts, count, &op, &moved) < 0)
        return -1;
    if (!op)
        return moved;
    cfs_wait(f->node, op);
    return cfs_end(op);
}

long nx_move_later(bool write, int fd, int64_t at, const struct iovec *parts, int count)
{
    struct node_file *f = file_of(fd);
    long id = 0;
    if (!f)
        return -1;
    struct io_id *ids = descriptors_open(f->node)->io;
    while (id < NODE_IO_IDS && ids[id].used)
        id++;
    if (id == NODE_IO_IDS)
        return node_error(f->node, EQNOMID, "out of ids (%d): iowait or iodone give them back", NODE_IO_IDS);
    ids[id].used = true;
    if (start(write, fd, f, at, parts, count, &ids[id].op, &ids[id].moved) < 0) {
        ids[id] = (struct io_id){0};
        return -1;
    }
    return id + 1; /* 0 is none, for programs */
}

/* --- ids --- */

/* The id that the call was given; NULL with the error. */
static struct io_id *find_id(struct node *n, long id)
{
    struct io_id *ids = descriptors_open(n)->io;
    gate_about(n, id);
    if (id < 1 || id > NODE_IO_IDS || !ids[id - 1].used) {
        node_error(n, EQMID, "%ld is no id in use", id);
        return NULL;
    }
    node_spend(n, n->sys->cfg->call_ps);
    return &ids[id - 1];
}

/* Returns the bytes moved, and frees the id. */
static long give_back(struct io_id *id)
{
    ssize_t moved = id->op ? cfs_end(id->op) : id->moved;
    *id = (struct io_id){0};
    return moved;
}

long nxs_iodone(word id)
{
    struct node *n = node_self();
    struct io_id *i = find_id(n, id);
    if (!i)
        return -1;
    node_order(n);
    bool done = !i->op || cfs_done(n, i->op);
    if (done)
        give_back(i);
    return done;
}

long nxs_iowait(word id)
{
    struct node *n = node_self();
    struct io_id *i = find_id(n, id);
    if (!i)
        return -1;
    if (i->op)
        cfs_wait(n, i->op);
    return give_back(i);
}

/* --- opening and modes --- */

static long set_mode(struct node *n, int fd, struct node_file *f, long mode)
{
    struct cfs_file *file = cfs_file_of(f);
    if (nx_check_io_mode(n, descriptor_path(n, fd), file, mode) < 0)
        return -1;
    if (file && cfs_mode(file) != mode)
        cfs_set_mode(file, (int)mode);
    return 0;
}

/* The file is opened as by open(), which is a call of its own. */
long nx_open_one(const char *call, const char *path, int flags, int mode, unsigned permissions, nx_end *end)
{
    struct node *n = node_self();
    int fd = descriptor_new(n, file_open(n, path, flags, permissions), path);
    int why = node_errno();
    node_enter(n, call);
    node_set_errno(why);
    if (fd < 0)
        return end(n, fail(n, path));
    if (set_mode(n, fd, descriptor_file(n, fd), mode) < 0) {
        descriptor_close(n, fd);
        fd = -1;
    }
    return end(n, fd);
}

long nxs_setiomode(word fd, word mode)
{
    struct node_file *f = file_of(fd);
    return f ? set_mode(f->node, fd, f, mode) : -1;
}

long nxs_iomode(word fd)
{
    struct node_file *f = file_of(fd);
    if (!f)
        return -1;
    return cfs_file_of(f) ? cfs_mode(cfs_file_of(f)) : M_UNIX;
}

/* --- pointers and sizes --- */

int64_t nx_seek(struct node *n, int fd, int64_t offset, int whence)
{
    struct node_file *f = file_of(fd);
    if (!f)
        return -1;
    int64_t at = f->class->seek(f, offset, whence);
    return at < 0 ? fail_on(n, fd) : at;
}

/* The offset that whence stands for. */
static int64_t start_of(struct node_file *f, int whence)
{
    struct stat st;
    if (whence == SIZE_SET)
        return 0;
    if (whence == SIZE_CUR)
        return f->class->seek(f, 0, SEEK_CUR);
    if (whence != SIZE_END) {
        errno = EINVAL;
        return -1;
    }
    return f->class->stat(f, &st) ? -1 : st.st_size;
}

int64_t nx_resize(struct node *n, int fd, int64_t offset, int whence)
{
    struct node_file *f = file_of(fd);
    if (!f)
        return -1;
    struct cfs_file *file = cfs_file_of(f);
    if (!file)
        return node_error(n, EINVAL, "%s: only files under /cfs or /pfs can be sized",
                          descriptor_path(n, fd));
    int64_t from = start_of(f, whence);
    if (from >= 0 && from + offset < 0)
        errno = EINVAL, from = -1;
    int64_t size = from < 0 ? -1 : cfs_grow(file, (uint64_t)(from + offset));
    return size < 0 ? fail_on(n, fd) : size;
}

long nxs_iseof(word fd)
{
    struct node_file *f = file_of(fd);
    struct stat st;
    if (!f)
        return -1;
    struct cfs_file *file = cfs_file_of(f);
    nx_spend_call(f->node);
    node_order(f->node);
    if (file)
        return cfs_at_end(file);
    return f->class->stat(f, &st) == 0 && f->class->seek(f, 0, SEEK_CUR) >= st.st_size;
}

long nxs_restrictvol(word fd, word count, const int disks[])
{
    struct node_file *f = file_of(fd);
    uint32_t list[1024];
    if (!f)
        return -1;
    struct cfs_file *file = cfs_file_of(f);
    if (!file || count < 1 || count > 1024 || !disks) {
        errno = EINVAL;
        return fail_on(f->node, fd);
    }
    for (int i = 0; i < count; i++)
        list[i] = (uint32_t)disks[i];
    return cfs_restrict(file, list, (uint32_t)count) ? fail_on(f->node, fd) : 0;
}

/* --- state --- */

/* As by stat(), which is a call of its own. */
long nx_stat_path(const char *call, bool link, const char *path, struct estat *e, nx_end *end)
{
    struct node *n = node_self();
    struct stat st;
    int r = link ? file_lstat(n, path, &st) : file_stat(n, path, &st), why = errno;
    if (r) {
        node_enter(n, call);
        errno = why;
        return end(n, fail(n, path));
    }
    nx_put_estat(node_self(), e, &st);
    return 0;
}

long nxs_festat(word fd, struct estat *e)
{
    struct node_file *f = file_of(fd);
    struct stat st;
    if (!f)
        return -1;
    if (f->class->stat(f, &st))
        return fail_on(f->node, fd);
    nx_put_estat(f->node, e, &st);
    return 0;
}
