/* sim_stripes.c - the striping of files over the machine's disks (pfs/pfs.h), and fcntl(). */
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include "cfs/cfs.h"
#include "guest/libc/libc_parts.h"
#include "nx_api/calls/call.h"
#include "nx_api/calls/statpfs.h"

enum { OTHER_BLOCK = 8192 };
static const int64_t OTHER_CAPACITY =
    INT64_C(2) << 30; /* of the host's file system: its real size must not change a run */

static void other_file_system(struct stripes *s)
{
    *s = (struct stripes){.capacity = OTHER_CAPACITY, .free = OTHER_CAPACITY, .block = OTHER_BLOCK};
}

static void own_file_system(const struct node *n, struct stripes *s)
{
    const struct cfg_cfs *c = &n->sys->cfg->cfs;
    int64_t bytes = (int64_t)(c->disks * c->cylinders * c->cylinder_blocks * c->block_bytes);
    *s = (struct stripes){.own = true, .capacity = bytes, .free = bytes, .block = (long)c->block_bytes};
    s->unit = (int)c->block_bytes;
    s->factor = (int)c->disks;
}

int stripes_of_path(struct node *n, const char *path, struct stripes *s)
{
    struct stat st;
    if (file_stat_within(n, path, &st))
        return -1;
    if (file_is_simulated(path))
        own_file_system(n, s);
    else
        other_file_system(s);
    return 0;
}

int stripes_of_file(struct node *n, int fd, struct stripes *s)
{
    struct node_file *f = descriptor_file(n, fd);
    if (!f)
        return -1;
    const struct cfs_file *file = cfs_file_of(f);
    if (!file) {
        other_file_system(s);
        return 0;
    }
    own_file_system(n, s);
    cfs_disks(file, &s->factor, &s->start);
    return 0;
}

int stripes_set(struct node *n, int fd, int factor, int start)
{
    uint32_t list[4096]; /* as many as a machine file allows */
    int disks = (int)n->sys->cfg->cfs.disks;
    errno = EINVAL;
    if (factor < 1 || factor > disks || start < 0 || start >= disks)
        return -1;
    for (int i = 0; i < factor; i++)
        list[i] = (uint32_t)((start + i) % disks);
    return cfs_restrict(cfs_file_of(descriptor_file(n, fd)), list, (uint32_t)factor);
}

/* A lock is the node's own: it gets each at once, and never finds one of another node's. */
static int lock(int what, struct flock *l)
{
    if (l->l_type != F_RDLCK && l->l_type != F_WRLCK && (l->l_type != F_UNLCK || what == F_GETLK)) {
        errno = EINVAL;
        return -1;
    }
    if (what == F_GETLK)
        l->l_type = F_UNLCK;
    return 0;
}

static bool is_lock(int what)
{
    return what == F_GETLK || what == F_SETLK || what == F_SETLKW;
}

/* Of other requests only those that every descriptor serves. */
int node_fcntl(int fd, int what, ...)
{
    va_list ap;
    va_start(ap, what);
    void *argument = nx_is_of_stripes(what) || is_lock(what) ? va_arg(ap, void *) : NULL;
    int number = what == F_DUPFD || what == F_SETFL ? va_arg(ap, int) : 0;
    va_end(ap);
    if (nx_is_of_stripes(what))
        return nx_stripes_control(fd, what, argument);
    if (what == F_DUPFD)
        return descriptor_copy_free(node_self(), fd, number);
    struct node_file *f = descriptor_file(node_self(), fd);
    if (!f)
        return -1;
    if (is_lock(what))
        return lock(what, argument);
    if (what == F_GETFD || what == F_SETFD)
        return 0;
    if (what == F_GETFL)
        return file_flags(f);
    if (what == F_SETFL)
        return file_set_flags(f, number);
    errno = EINVAL;
    return -1;
}
