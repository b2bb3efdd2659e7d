/* files.c - the NX calls on files, served by the simulator. On files of this computer they work too, at once and
 * without taking time; the I/O mode there is always 0. */
#include <errno.h>
#include <stddef.h>
#include <string.h>
#include "cfs/cfs.h"
#include "guest/libc_parts.h"
#include "nx_api/sim/call.h"
#include "guest/host_errno.h"
#include "node/self.h"
#include "os/fail.h"
#include "os/front.h"
#include "os/gate.h"
#include "os/longs.h"

/* --- errors --- */

/* An error that errno tells of. */
static long fail(struct node *n, const char *what)
{
    int why = node_errno();
    return node_error(n, why, "%s: %s", what, strerror(why));
}

static long fail_on(struct node *n, int fd)
{
    return fail(n, descriptor_path(n, fd));
}

/* The file of a descriptor; NULL with the error when it is not open. */
static struct node_file *file_of(int fd)
{
    struct node *n = node_self();
    struct node_file *f = descriptor_file(n, fd);
    if (!f)
        node_error(n, EBADF, "%d is not an open file", fd);
    return f;
}

/* --- reading and writing --- */

static long check_parts(struct node *n, const struct iovec *parts, long count)
{
    if (count < 0 || count > 1024)
        return node_error(n, EQLEN, "%ld parts; 0 to 1024 are allowed", count);
    for (long i = 0; i < count; i++)
        if (!parts[i].iov_base && parts[i].iov_len)
            return node_error(n, EQPBUF, "the buffer is a null pointer");
    return 0;
}

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

/* A file of this computer: moved at once. */
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

/* Starts it. *op is NULL when it is done already, with *moved bytes. */
static long start(bool write, int fd, struct node_file *f, int64_t at, const struct iovec *parts, int count,
                  struct cfs_op **op, ssize_t *moved)
{
    struct cfs_file *file = cfs_file_of(f);
    if (check_parts(f->node, parts, count) < 0)
        return -1;
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

/* The id given to the call; NULL with the error. */
static struct io_id *find_id(struct node *n, long id)
{
    struct io_id *ids = descriptors_open(n)->io;
    n->call_type = id;
    n->call_has_type = true;
    if (id < 1 || id > NODE_IO_IDS || !ids[id - 1].used) {
        node_error(n, EQMID, "%ld is no id in use", id);
        return NULL;
    }
    node_spend(n, n->sys->cfg->call_ps);
    return &ids[id - 1];
}

/* The bytes moved. */
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
    if (mode < M_UNIX || mode > M_ASYNC)
        return node_error(n, EINVAL, "%s: there is no I/O mode %ld (0 to 5)", descriptor_path(n, fd), mode);
    if (!file && mode >= M_LOG && mode <= M_RECORD)
        return node_error(n, EINVAL, "%s: only files under /cfs or /pfs share a pointer (I/O mode %ld)",
                          descriptor_path(n, fd), mode);
    if (file && cfs_mode(file) != mode)
        cfs_set_mode(file, (int)mode);
    return 0;
}

/* gopen's part on one node. The file is opened as by open(), which enters and leaves by itself. */
static long open_one(const char *call, const char *path, int flags, int mode, unsigned permissions,
                     nx_face *face)
{
    struct node *n = node_self();
    int fd = descriptor_new(n, file_open(n, path, flags, permissions), path);
    int why = node_errno();
    node_enter(n, call);
    node_set_errno(why);
    if (fd < 0)
        return face(n, fail(n, path));
    return face(n, set_mode(n, fd, descriptor_file(n, fd), mode) < 0 ? -1 : fd);
}

long node_nx_gopen_one(const char *path, int flags, int mode, unsigned permissions)
{
    return open_one("gopen", path, flags, mode, permissions, nx_plain);
}

long node__nx_gopen_one(const char *path, int flags, int mode, unsigned permissions)
{
    return open_one("_gopen", path, flags, mode, permissions, nx_returning);
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

static int64_t from_esize(esize_t s)
{
    return (int64_t)((uint64_t)(uint32_t)s.shigh << 32 | (uint32_t)s.slow);
}

static esize_t to_esize(int64_t x)
{
    return (esize_t){(long)(uint32_t)x, (long)(x >> 32)};
}

/* A size, or -1 for an error. */
static int64_t size_call(const char *call, int64_t (*f)(struct node *, int, int64_t, int), nx_face *face,
                         int fd, int64_t offset, int whence)
{
    struct node *n = node_self();
    node_enter(n, call);
    int64_t size = f(n, fd, offset, whence);
    face(n, size < 0 ? -1 : 0);
    return size < 0 ? -1 : size;
}

static esize_t size_or_error(int64_t size)
{
    return size < 0 ? (esize_t){-1, -1} : to_esize(size);
}

/* NAME and _NAME; and where long has 32 bits, so that an esize_t is a word of 64. */
#define SIZE_CALLS(name, f)                                                                                  \
    esize_t node_##name(int fd, esize_t offset, int whence)                                                  \
    {                                                                                                        \
        return size_or_error(size_call(#name, f, nx_plain, fd, from_esize(offset), whence));                 \
    }                                                                                                        \
    esize_t node__##name(int fd, esize_t offset, int whence)                                                 \
    {                                                                                                        \
        return size_or_error(size_call("_" #name, f, nx_returning, fd, from_esize(offset), whence));         \
    }                                                                                                        \
    int64_t node_long32_##name(int fd, int64_t offset, int whence)                                           \
    {                                                                                                        \
        return size_call(#name, f, nx_plain, fd, offset, whence);                                            \
    }                                                                                                        \
    int64_t node_long32__##name(int fd, int64_t offset, int whence)                                          \
    {                                                                                                        \
        return size_call("_" #name, f, nx_returning, fd, offset, whence);                                    \
    }

static int64_t seek(struct node *n, int fd, int64_t offset, int whence)
{
    struct node_file *f = file_of(fd);
    if (!f)
        return -1;
    int64_t at = f->class->seek(f, offset, whence);
    return at < 0 ? fail_on(n, fd) : at;
}

SIZE_CALLS(eseek, seek)

/* Where the present size, or the pointer, is. */
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

static int64_t resize(struct node *n, int fd, int64_t offset, int whence)
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

long nxs_lsize(word fd, word offset, word whence)
{
    return resize(node_self(), fd, offset, whence);
}

SIZE_CALLS(esize, resize)

/* Where long has 32 bits. */
#define OFFSET_CALL(name, served, buffer, face)                                                              \
    long node_long32_##name(word fd, int64_t offset, buffer buf, size_word len)                              \
    {                                                                                                        \
        struct node *n = node_self();                                                                        \
        node_enter(n, #name);                                                                                \
        return face(n, served(fd, (word)offset, (word)(offset >> 32), buf, len));                            \
    }
#define OFFSET_CALLS(name, buffer)                                                                           \
    OFFSET_CALL(name, nxs_##name, buffer, nx_plain) OFFSET_CALL(_##name, nxs_##name, buffer, nx_returning)

OFFSET_CALLS(readoff, void *)
OFFSET_CALLS(writeoff, const void *)
OFFSET_CALLS(ireadoff, void *)
OFFSET_CALLS(iwriteoff, const void *)

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
    if (!file || count < 1 || count > 1024) {
        errno = EINVAL;
        return fail_on(f->node, fd);
    }
    for (int i = 0; i < count; i++)
        list[i] = (uint32_t)disks[i];
    return cfs_restrict(file, list, (uint32_t)count) ? fail_on(f->node, fd) : 0;
}

/* --- state --- */

static void to_estat(const struct node *n, struct estat *e, const struct stat *st)
{
    struct estat all = {.st_dev = st->st_dev,
                        .st_ino = st->st_ino,
                        .st_mode = st->st_mode,
                        .st_nlink = st->st_nlink,
                        .st_uid = st->st_uid,
                        .st_gid = st->st_gid,
                        .st_rdev = st->st_rdev,
                        .st_size = to_esize(st->st_size),
                        .st_blksize = st->st_blksize,
                        .st_blocks = st->st_blocks,
                        .st_atim = st->st_atim,
                        .st_mtim = st->st_mtim,
                        .st_ctim = st->st_ctim};
    size_t before = offsetof(struct estat, st_size), after = before + sizeof all.st_size;
    memcpy(e, &all, before);
    node_put_long(n, &e->st_size.slow, 0, all.st_size.slow);
    node_put_long(n, &e->st_size.slow, 1, all.st_size.shigh);
    memcpy((char *)e + before + 2 * node_long_bytes(n), (char *)&all + after, sizeof all - after);
}

/* As by stat(), which enters and leaves by itself. */
static long stat_path(const char *call, int (*get)(struct node *, const char *, struct stat *),
                      const char *path, struct estat *e, nx_face *face)
{
    struct node *n = node_self();
    struct stat st;
    int r = get(n, path, &st), why = errno;
    if (r) {
        node_enter(n, call);
        errno = why;
        return face(n, fail(n, path));
    }
    to_estat(node_self(), e, &st);
    return 0;
}

long node_estat(const char *path, struct estat *e)
{
    return stat_path("estat", file_stat, path, e, nx_plain);
}

long node__estat(const char *path, struct estat *e)
{
    return stat_path("_estat", file_stat, path, e, nx_returning);
}

long node_lestat(const char *path, struct estat *e)
{
    return stat_path("lestat", file_lstat, path, e, nx_plain);
}

long node__lestat(const char *path, struct estat *e)
{
    return stat_path("_lestat", file_lstat, path, e, nx_returning);
}

long nxs_festat(word fd, struct estat *e)
{
    struct node_file *f = file_of(fd);
    struct stat st;
    if (!f)
        return -1;
    if (f->class->stat(f, &st))
        return fail_on(f->node, fd);
    to_estat(f->node, e, &st);
    return 0;
}
