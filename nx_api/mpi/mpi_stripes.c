/* mpi_stripes.c - the striping of files (pfs/pfs.h), where one folder stands for the machine's file system:
 * over one disk, in units of the folder's best transfers. */
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <unistd.h>
#include "nx_api/calls/call.h"
#include "nx_api/calls/statpfs.h"
#include "nx_api/mpi/mpi_files.h"
#include "nx_api/mpi/mpi_paths.h"

static int fill(struct stripes *s, const struct statvfs *fs, bool own)
{
    *s = (struct stripes){.own = own, .block = (long)fs->f_bsize};
    s->capacity = (int64_t)(fs->f_blocks * fs->f_frsize);
    s->free = (int64_t)(fs->f_bavail * fs->f_frsize);
    s->unit = own ? (int)fs->f_bsize : 0;
    s->factor = own;
    return 0;
}

int stripes_of_path(struct node *n, const char *path, struct stripes *s)
{
    char space[PATH_MAX];
    struct statvfs fs;
    const char *here = path_here(path, space);
    (void)n;
    return here && statvfs(here, &fs) == 0 ? fill(s, &fs, path_is_cfs(path)) : -1;
}

int stripes_of_file(struct node *n, int fd, struct stripes *s)
{
    const struct open_file *f = files_find(fd);
    struct statvfs fs;
    (void)n;
    errno = EBADF;
    return f && fstatvfs(fd, &fs) == 0 ? fill(s, &fs, path_is_cfs(f->path)) : -1;
}

/* There is one disk. */
int stripes_set(struct node *n, int fd, int factor, int start)
{
    (void)n, (void)fd;
    errno = EINVAL;
    return factor == 1 && start == 0 ? 0 : -1;
}

int node_fcntl(int fd, int what, ...) NX_EXPORT("fcntl");
int node_fcntl64(int fd, int what, ...) NX_EXPORT("fcntl64") __attribute__((alias("fcntl")));

/* Other requests are the host's. */
int node_fcntl(int fd, int what, ...)
{
    va_list ap;
    va_start(ap, what);
    void *argument = va_arg(ap, void *);
    va_end(ap);
    if (nx_is_of_stripes(what))
        return nx_stripes_control(fd, what, argument);
    int answer = (int)syscall(SYS_fcntl, fd, what, argument);
    if ((what == F_DUPFD || what == F_DUPFD_CLOEXEC) && answer >= 0)
        files_copied(fd, answer);
    return answer;
}
