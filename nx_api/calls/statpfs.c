/* statpfs.c - the Parallel File System's own calls: statpfs and fstatpfs, and what fcntl asks of stripes. See
 * nx_api/include/pfs/pfs.h. */
#include "nx_api/calls/statpfs.h"
#include <errno.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include "nx_api/calls/call.h"
#include "nx_api/include/pfs/pfs.h"

enum { UNIT = 1024 }; /* of f_blocks, f_bfree, f_bavail */

/* Not inlined: a call that has waited may be on another thread, which has another errno, and compilers
 * compute the address of errno once in a function. */
__attribute__((noinline)) static int why(void)
{
    return errno;
}

/* --- statpfs --- */

static void put_blocks(const struct node *n, struct estatfs *fs, long which, int64_t bytes)
{
    int64_t blocks = bytes / UNIT;
    node_put_long(n, &fs->f_blocks.slow, 2 * which, (long)(uint32_t)blocks);
    node_put_long(n, &fs->f_blocks.slow, 2 * which + 1, (long)(blocks >> 32));
}

/* The members behind the three sizes lie where the program's longs put them. */
static void put_file_system(const struct node *n, struct estatfs *fs, const struct stripes *s)
{
    struct estatfs all = {
        .f_type = s->own ? MOUNT_PFS : MOUNT_UFS, .f_fsize = UNIT, .f_bsize = (int)s->block};
    snprintf(all.f_mntonname, sizeof all.f_mntonname, "%s", s->own ? "/pfs" : "/");
    put_blocks(n, fs, 0, s->capacity);
    put_blocks(n, fs, 1, s->free);
    put_blocks(n, fs, 2, s->free);
    memcpy((char *)fs + 6 * node_long_bytes(n), &all.f_type,
           offsetof(struct estatfs, f_mntonname) + sizeof all.f_mntonname - offsetof(struct estatfs, f_type));
}

static long fill(struct node *n, const struct stripes *s, struct estatfs *fs, struct statpfs *stripes,
                 unsigned size)
{
    if (!fs)
        return node_error(n, EQPBUF, "the place for the file system is a null pointer");
    put_file_system(n, fs, s);
    if (stripes && size >= sizeof *stripes)
        *stripes = (struct statpfs){sizeof *stripes, s->unit, s->factor};
    return 0;
}

long node_statpfs(const char *path, struct estatfs *fs, struct statpfs *stripes, unsigned size)
    NX_EXPORT("statpfs");
long node__statpfs(const char *path, struct estatfs *fs, struct statpfs *stripes, unsigned size)
    NX_EXPORT("_statpfs");
long node_fstatpfs(int fd, struct estatfs *fs, struct statpfs *stripes, unsigned size) NX_EXPORT("fstatpfs");
long node__fstatpfs(int fd, struct estatfs *fs, struct statpfs *stripes, unsigned size)
    NX_EXPORT("_fstatpfs");

long node_statpfs(const char *path, struct estatfs *fs, struct statpfs *stripes, unsigned size)
{
    struct node *n = node_self();
    struct stripes s = {0};
    node_enter(n, "statpfs");
    if (stripes_of_path(n, path, &s))
        return nx_returning(n, node_error(n, why(), "%s", path));
    return nx_returning(n, fill(n, &s, fs, stripes, size));
}

long node__statpfs(const char *path, struct estatfs *fs, struct statpfs *stripes, unsigned size)
{
    return node_statpfs(path, fs, stripes, size);
}

long node_fstatpfs(int fd, struct estatfs *fs, struct statpfs *stripes, unsigned size)
{
    struct node *n = node_self();
    struct stripes s = {0};
    node_enter(n, "fstatpfs");
    if (stripes_of_file(n, fd, &s))
        return nx_returning(n, node_error(n, why(), "file %d", fd));
    return nx_returning(n, fill(n, &s, fs, stripes, size));
}

long node__fstatpfs(int fd, struct estatfs *fs, struct statpfs *stripes, unsigned size)
{
    return node_fstatpfs(fd, fs, stripes, size);
}

/* --- fcntl --- */

static int get_attributes(struct node *n, int fd, struct sattr *a)
{
    struct stripes s = {0};
    if (stripes_of_file(n, fd, &s))
        return -1;
    *a = (struct sattr){s.unit, s.factor, s.start};
    errno = EINVAL;
    return s.own ? 0 : -1;
}

static int set_attributes(struct node *n, int fd, const struct sattr *a)
{
    struct sattr now;
    if (get_attributes(n, fd, &now))
        return -1;
    errno = EINVAL;
    return a->s_sunitsize == now.s_sunitsize ? stripes_set(n, fd, a->s_sfactor, a->s_start_sdir) : -1;
}

static int control(struct node *n, int fd, int what, void *argument)
{
    struct stripes s = {0};
    if (what == F_PFS_SVR_BUF)
        return stripes_of_file(n, fd, &s);
    return what == F_GETSATTR ? get_attributes(n, fd, argument) : set_attributes(n, fd, argument);
}

int nx_stripes_control(int fd, int what, void *argument)
{
    struct node *n = node_self();
    node_enter(n, "fcntl");
    int r = control(n, fd, what, argument);
    return (int)nx_returning(n, r ? node_error(n, why(), "file %d", fd) : 0);
}
