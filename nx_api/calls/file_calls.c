/* file_calls.c - the calls on files that are the same on all back ends. */
#include "nx_api/calls/file_calls.h"
#include <errno.h>
#include <string.h>

/* --- checks --- */

long nx_check_parts(struct node *n, const struct iovec *parts, long count)
{
    if (count < 0 || count > 1024)
        return node_error(n, EQLEN, "%ld parts; 0 to 1024 are allowed", count);
    if (count > 0 && !parts)
        return node_error(n, EQPBUF, "the list of parts is a null pointer");
    for (long i = 0; i < count; i++)
        if (!parts[i].iov_base && parts[i].iov_len)
            return node_error(n, EQPBUF, "the buffer is a null pointer");
    return 0;
}

long nx_check_io_mode(struct node *n, const char *name, bool simulated, long mode)
{
    if (mode < M_UNIX || mode > M_ASYNC)
        return node_error(n, EINVAL, "%s: there is no I/O mode %ld (0 to 5)", name, mode);
    if (!simulated && mode >= M_LOG && mode <= M_RECORD)
        return node_error(n, EINVAL, "%s: only files under /cfs or /pfs share a pointer (I/O mode %ld)", name,
                          mode);
    return 0;
}

/* --- opening: gopen's part on one node --- */

long node_nx_gopen_one(const char *path, int flags, int mode, unsigned permissions) NX_EXPORT("nx_gopen_one");
long node__nx_gopen_one(const char *path, int flags, int mode, unsigned permissions)
    NX_EXPORT("_nx_gopen_one");

long node_nx_gopen_one(const char *path, int flags, int mode, unsigned permissions)
{
    return nx_open_one("gopen", path, flags, mode, permissions, nx_plain);
}

long node__nx_gopen_one(const char *path, int flags, int mode, unsigned permissions)
{
    return nx_open_one("_gopen", path, flags, mode, permissions, nx_returning);
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

int64_t nx_size_call(const char *call, nx_sizing *f, nx_end *end, int fd, int64_t offset, int whence)
{
    struct node *n = node_self();
    node_enter(n, call);
    int64_t size = f(n, fd, offset, whence);
    end(n, size < 0 ? -1 : 0);
    return size < 0 ? -1 : size;
}

static esize_t size_or_error(int64_t size)
{
    return size < 0 ? (esize_t){-1, -1} : to_esize(size);
}

#define SIZE_CALL(name, f, end)                                                                              \
    esize_t node_##name(int fd, esize_t offset, int whence) NX_EXPORT(#name);                                \
    esize_t node_##name(int fd, esize_t offset, int whence)                                                  \
    {                                                                                                        \
        return size_or_error(nx_size_call(#name, f, end, fd, from_esize(offset), whence));                   \
    }

SIZE_CALL(eseek, nx_seek, nx_plain)
SIZE_CALL(_eseek, nx_seek, nx_returning)
SIZE_CALL(esize, nx_resize, nx_plain)
SIZE_CALL(_esize, nx_resize, nx_returning)

long nxs_lsize(word fd, word offset, word whence)
{
    return nx_resize(node_self(), fd, offset, whence);
}

/* --- state --- */

void nx_put_estat(const struct node *n, struct estat *e, const struct stat *st)
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

#define STAT_CALL(name, link, end)                                                                           \
    long node_##name(const char *path, struct estat *e) NX_EXPORT(#name);                                    \
    long node_##name(const char *path, struct estat *e)                                                      \
    {                                                                                                        \
        return nx_stat_path(#name, link, path, e, end);                                                      \
    }

STAT_CALL(estat, false, nx_plain)
STAT_CALL(_estat, false, nx_returning)
STAT_CALL(lestat, true, nx_plain)
STAT_CALL(_lestat, true, nx_returning)
