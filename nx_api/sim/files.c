/* files.c - the NX calls on files, served by the simulator. On files of this computer they work too, at once and
 * without taking time; the I/O mode there is always 0. */
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <string.h>
#include "cfs/cfs.h"
#include "nx_api/include/estat.h"
#include "node/cpu.h"
#include "node/libc_parts.h"

#define LOW(x) ((long)(int32_t)(x))

/* --- entering --- */

static _Noreturn void fail(struct node *n, const char *what)
{
    node_fail(n, "%s: %s: %s", n->call, what, strerror(errno));
}

/* Enter a call on a descriptor that must be open. */
static struct node_file *enter(const char *call, int fd)
{
    struct node *n = node_self();
    node_enter(n, call);
    struct node_file *f = descriptor_file(n, fd);
    if (!f)
        node_fail(n, "%s: %d is not an open file", call, fd);
    return f;
}

static _Noreturn void fail_on(struct node *n, int fd)
{
    fail(n, descriptor_path(n, fd));
}

/* --- reading and writing --- */

struct io_call {
    const char *name;
    bool write;
};

static const struct iovec *check_parts(struct node *n, const struct iovec *parts, long count)
{
    if (count < 0 || count > 1024)
        node_fail(n, "%s: %ld parts; 0 to 1024 are allowed", n->call, count);
    for (long i = 0; i < count; i++)
        if (!parts[i].iov_base && parts[i].iov_len)
            node_fail(n, "%s: the buffer is a null pointer", n->call);
    return parts;
}

/* A file of this computer: moved at once. */
static ssize_t move_host(struct node_file *f, bool write, const struct iovec *parts, int count)
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

/* Starts it. *op is NULL when it is done already, with *moved bytes. */
static void start(struct io_call c, int fd, struct node_file *f, const struct iovec *parts, int count,
                  struct cfs_op **op, ssize_t *moved)
{
    struct cfs_file *file = cfs_file_of(f);
    struct node *n = f->node;
    check_parts(n, parts, count);
    *op = file ? cfs_start(file, c.write, parts, count) : NULL;
    *moved = file ? 0 : move_host(f, c.write, parts, count);
    if ((file && !*op) || *moved < 0)
        fail_on(n, fd);
}

static long move(struct io_call c, int fd, const struct iovec *parts, int count)
{
    struct node_file *f = enter(c.name, fd);
    struct cfs_op *op;
    ssize_t moved;
    start(c, fd, f, parts, count, &op, &moved);
    if (op) {
        cfs_wait(f->node, op);
        moved = cfs_end(op);
    }
    node_leave(f->node);
    return moved;
}

static long move_later(struct io_call c, int fd, const struct iovec *parts, int count)
{
    struct node_file *f = enter(c.name, fd);
    struct io_id *ids = f->node->libc->descriptors.io;
    long id = 0;
    ssize_t moved;
    while (id < NODE_IO_IDS && ids[id].used)
        id++;
    if (id == NODE_IO_IDS)
        node_fail(f->node, "%s: out of ids (%d): iowait or iodone give them back", c.name, NODE_IO_IDS);
    ids[id].used = true;
    start(c, fd, f, parts, count, &ids[id].op, &moved);
    node_leave(f->node);
    return id;
}

/* A buffer as a part. Lengths are the machine's: 32 bits. */
static struct iovec whole(const void *buf, unsigned long len)
{
    return (struct iovec){(void *)(uintptr_t)buf, (uint32_t)len};
}

long node_cread(int fd, void *buf, unsigned long len)
{
    struct iovec part = whole(buf, len);
    return move((struct io_call){"cread", false}, fd, &part, 1);
}

long node_cwrite(int fd, const void *buf, unsigned long len)
{
    struct iovec part = whole(buf, len);
    return move((struct io_call){"cwrite", true}, fd, &part, 1);
}

long node_creadv(int fd, const struct iovec *parts, int count)
{
    return move((struct io_call){"creadv", false}, fd, parts, count);
}

long node_cwritev(int fd, const struct iovec *parts, int count)
{
    return move((struct io_call){"cwritev", true}, fd, parts, count);
}

long node_iread(int fd, void *buf, unsigned long len)
{
    struct iovec part = whole(buf, len);
    return move_later((struct io_call){"iread", false}, fd, &part, 1);
}

long node_iwrite(int fd, const void *buf, unsigned long len)
{
    struct iovec part = whole(buf, len);
    return move_later((struct io_call){"iwrite", true}, fd, &part, 1);
}

long node_ireadv(int fd, const struct iovec *parts, int count)
{
    return move_later((struct io_call){"ireadv", false}, fd, parts, count);
}

long node_iwritev(int fd, const struct iovec *parts, int count)
{
    return move_later((struct io_call){"iwritev", true}, fd, parts, count);
}

/* --- ids --- */

static struct io_id *enter_id(const char *call, long id)
{
    struct node *n = node_self();
    node_enter(n, call);
    n->call_type = id;
    n->call_has_type = true;
    if (id < 0 || id >= NODE_IO_IDS || !n->libc->descriptors.io[id].used)
        node_fail(n, "%s: %ld is no id in use", call, id);
    node_spend(n, n->sys->cfg->call_ps);
    return &n->libc->descriptors.io[id];
}

static void give_back(struct io_id *id)
{
    if (id->op)
        cfs_end(id->op);
    *id = (struct io_id){0};
}

long node_iodone(long id)
{
    struct io_id *i = enter_id("iodone", LOW(id));
    struct node *n = node_self();
    node_order(n);
    bool done = !i->op || cfs_done(n, i->op);
    if (done)
        give_back(i);
    node_leave(n);
    return done;
}

void node_iowait(long id)
{
    struct io_id *i = enter_id("iowait", LOW(id));
    struct node *n = node_self();
    if (i->op)
        cfs_wait(n, i->op);
    give_back(i);
    node_leave(n);
}

/* --- opening and modes --- */

static void set_mode(struct node *n, int fd, struct node_file *f, long mode)
{
    enum { M_ASYNC = 5 }; /* the Paragon's name for mode 0 without its promises */
    struct cfs_file *file = cfs_file_of(f);
    if (mode == M_ASYNC)
        mode = M_UNIX;
    if (mode < M_UNIX || mode > M_RECORD)
        node_fail(n, "%s: %s: there is no I/O mode %ld (0 to 3)", n->call, descriptor_path(n, fd), mode);
    if (!file && mode != M_UNIX)
        node_fail(n, "%s: %s: only files under /cfs have I/O modes other than 0", n->call,
                  descriptor_path(n, fd));
    if (file && cfs_mode(file) != mode)
        cfs_set_mode(file, (int)mode);
}

int node_nx_gopen_one(const char *path, int flags, int iomode, unsigned permissions)
{
    struct node *n = node_self();
    int fd = descriptor_new(n, file_open(n, path, flags, permissions), path);
    int why = errno;
    node_enter(n, "gopen");
    errno = why;
    if (fd < 0)
        fail(n, path);
    set_mode(n, fd, descriptor_file(n, fd), LOW(iomode));
    node_leave(n);
    return fd;
}

void node_setiomode(int fd, int mode)
{
    struct node_file *f = enter("setiomode", fd);
    set_mode(f->node, fd, f, mode);
    node_leave(f->node);
}

long node_iomode(int fd)
{
    struct node_file *f = enter("iomode", fd);
    long mode = cfs_file_of(f) ? cfs_mode(cfs_file_of(f)) : M_UNIX;
    node_leave(f->node);
    return mode;
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

esize_t node_eseek(int fd, esize_t offset, int whence)
{
    struct node_file *f = enter("eseek", fd);
    int64_t at = f->class->seek(f, from_esize(offset), whence);
    if (at < 0)
        fail_on(f->node, fd);
    node_leave(f->node);
    return to_esize(at);
}

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

static int64_t resize(const char *call, int fd, int64_t offset, int whence)
{
    struct node_file *f = enter(call, fd);
    struct cfs_file *file = cfs_file_of(f);
    if (!file)
        node_fail(f->node, "%s: %s: only files under /cfs can be sized", call, descriptor_path(f->node, fd));
    int64_t from = start_of(f, whence);
    if (from >= 0 && from + offset < 0)
        errno = EINVAL, from = -1;
    int64_t size = from < 0 ? -1 : cfs_grow(file, (uint64_t)(from + offset));
    if (size < 0)
        fail_on(f->node, fd);
    node_leave(f->node);
    return size;
}

long node_lsize(int fd, long offset, int whence)
{
    return resize("lsize", fd, LOW(offset), whence);
}

esize_t node_esize(int fd, esize_t offset, int whence)
{
    return to_esize(resize("esize", fd, from_esize(offset), whence));
}

long node_iseof(int fd)
{
    struct node_file *f = enter("iseof", fd);
    struct cfs_file *file = cfs_file_of(f);
    struct stat st;
    node_spend(f->node, f->node->sys->cfg->call_ps);
    node_order(f->node);
    bool end =
        file ? cfs_at_end(file) : f->class->stat(f, &st) == 0 && f->class->seek(f, 0, SEEK_CUR) >= st.st_size;
    node_leave(f->node);
    return end;
}

void node_restrictvol(int fd, int count, const int disks[])
{
    struct node_file *f = enter("restrictvol", fd);
    struct cfs_file *file = cfs_file_of(f);
    uint32_t list[1024];
    if (!file || count < 1 || count > 1024)
        errno = EINVAL, fail_on(f->node, fd);
    for (int i = 0; i < count; i++)
        list[i] = (uint32_t)disks[i];
    if (cfs_restrict(file, list, (uint32_t)count))
        fail_on(f->node, fd);
    node_leave(f->node);
}

/* --- state --- */

static void to_estat(struct estat *e, const struct stat *st)
{
    *e = (struct estat){.st_dev = st->st_dev,
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
}

long node_estat(const char *path, struct estat *e)
{
    struct node *n = node_self();
    struct stat st;
    int r = file_stat(n, path, &st), why = errno;
    if (r) {
        node_enter(n, "estat");
        errno = why;
        fail(n, path);
    }
    to_estat(e, &st);
    return 0;
}

long node_festat(int fd, struct estat *e)
{
    struct node_file *f = enter("festat", fd);
    struct stat st;
    if (f->class->stat(f, &st))
        fail_on(f->node, fd);
    node_leave(f->node);
    to_estat(e, &st);
    return 0;
}
