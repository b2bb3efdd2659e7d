/* mpi_paths.c - see mpi_paths.h; and libnx.a's forms of the C library's calls that take names of files. */
#include "nx_api/mpi/mpi_paths.h"
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include "nx_api/mpi/mpi_files.h"
#include "backend_node.h"

bool path_is_cfs(const char *path)
{
    return path && (!strncmp(path, "/cfs", 4) || !strncmp(path, "/pfs", 4)) && (path[4] == '/' || !path[4]);
}

static bool goes_up(const char *path)
{
    for (const char *p = strstr(path, "/.."); p; p = strstr(p + 1, "/.."))
        if (p[3] == '/' || !p[3])
            return true;
    return false;
}

const char *path_here(const char *path, char space[PATH_MAX])
{
    const char *folder = getenv("TOUCHSTONE_CFS");
    if (!path)
        errno = EFAULT;
    if (!path_is_cfs(path))
        return path;
    if (goes_up(path)) {
        errno = EACCES;
        return NULL;
    }
    int n = snprintf(space, PATH_MAX, "%s%s", folder && *folder ? folder : "cfs", path + 4);
    if (n < PATH_MAX)
        return space;
    errno = ENAMETOOLONG;
    return NULL;
}

void path_make_folders(const char *here)
{
    char part[PATH_MAX];
    for (const char *slash = strchr(here + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        snprintf(part, sizeof part, "%.*s", (int)(slash - here), here);
        mkdir(part, 0777);
    }
}

/* --- the C library's calls, for names under /cfs, too, also by the names that headers give them with
 * -D_FILE_OFFSET_BITS=64. Each reaches the system by another function than its own. --- */

int node_open(const char *path, int flags, ...) NX_EXPORT("open");
int node_open64(const char *path, int flags, ...) NX_EXPORT("open64") __attribute__((alias("open")));
int node_creat(const char *path, mode_t mode) NX_EXPORT("creat");
int node_creat64(const char *path, mode_t mode) NX_EXPORT("creat64") __attribute__((alias("creat")));
FILE *node_fopen(const char *path, const char *mode) NX_EXPORT("fopen");
FILE *node_fopen64(const char *path, const char *mode) NX_EXPORT("fopen64") __attribute__((alias("fopen")));
FILE *node_freopen(const char *path, const char *mode, FILE *f) NX_EXPORT("freopen");
FILE *node_freopen64(const char *path, const char *mode, FILE *f) NX_EXPORT("freopen64")
    __attribute__((alias("freopen")));
int node_truncate(const char *path, off_t bytes) NX_EXPORT("truncate");
int node_truncate64(const char *path, off_t bytes) NX_EXPORT("truncate64") __attribute__((alias("truncate")));
int node_stat(const char *path, struct stat *st) NX_EXPORT("stat");
int node_stat64(const char *path, struct stat *st) NX_EXPORT("stat64") __attribute__((alias("stat")));
int node_access(const char *path, int how) NX_EXPORT("access");
int node_unlink(const char *path) NX_EXPORT("unlink");
int node_remove(const char *path) NX_EXPORT("remove");
int node_rename(const char *from, const char *to) NX_EXPORT("rename");

int path_open(const char *path, int flags, unsigned mode)
{
    char space[PATH_MAX];
    const char *here = path_here(path, space);
    if (here && here != path && flags & O_CREAT)
        path_make_folders(here);
    int fd = here ? openat(AT_FDCWD, here, flags, mode) : -1;
    if (fd >= 0)
        files_opened(fd, path);
    return fd;
}

int node_open(const char *path, int flags, ...)
{
    mode_t mode = 0;
    if (flags & (O_CREAT | O_TMPFILE)) {
        va_list ap;
        va_start(ap, flags);
        mode = va_arg(ap, mode_t);
        va_end(ap);
    }
    return path_open(path, flags, mode);
}

int node_creat(const char *path, mode_t mode)
{
    return path_open(path, O_WRONLY | O_CREAT | O_TRUNC, mode);
}

static const char *for_stream(const char *path, const char *mode, char space[PATH_MAX])
{
    const char *here = path_here(path, space);
    if (here && here != path && *mode != 'r')
        path_make_folders(here);
    return here;
}

/* Notes under which name a stream has been opened; NULL: it has not. */
static FILE *opened(FILE *f, const char *path)
{
    if (f && path)
        files_opened(fileno(f), path);
    return f;
}

FILE *node_fopen(const char *path, const char *mode)
{
    char space[PATH_MAX];
    const char *here = for_stream(path, mode, space);
    FILE *(*libc_fopen)(const char *, const char *);
    *(void **)&libc_fopen = dlsym(RTLD_NEXT, "fopen");
    return here ? opened(libc_fopen(here, mode), path) : NULL;
}

FILE *node_freopen(const char *path, const char *mode, FILE *f)
{
    char space[PATH_MAX];
    const char *here = path ? for_stream(path, mode, space) : NULL;
    FILE *(*libc_freopen)(const char *, const char *, FILE *);
    *(void **)&libc_freopen = dlsym(RTLD_NEXT, "freopen");
    return here || !path ? opened(libc_freopen(here, mode, f), path) : NULL;
}

int node_truncate(const char *path, off_t bytes)
{
    char space[PATH_MAX];
    const char *here = path_here(path, space);
    return here ? (int)syscall(SYS_truncate, here, bytes) : -1;
}

int node_stat(const char *path, struct stat *st)
{
    char space[PATH_MAX];
    const char *here = path_here(path, space);
    return here ? fstatat(AT_FDCWD, here, st, 0) : -1;
}

int node_access(const char *path, int how)
{
    char space[PATH_MAX];
    const char *here = path_here(path, space);
    return here ? faccessat(AT_FDCWD, here, how, 0) : -1;
}

int node_unlink(const char *path)
{
    char space[PATH_MAX];
    const char *here = path_here(path, space);
    return here ? unlinkat(AT_FDCWD, here, 0) : -1;
}

int node_remove(const char *path)
{
    char space[PATH_MAX];
    const char *here = path_here(path, space);
    if (!here)
        return -1;
    if (unlinkat(AT_FDCWD, here, 0) == 0)
        return 0;
    return errno == EISDIR ? unlinkat(AT_FDCWD, here, AT_REMOVEDIR) : -1;
}

int node_rename(const char *from, const char *to)
{
    char old[PATH_MAX], new[PATH_MAX];
    const char *old_here = path_here(from, old), *new_here = path_here(to, new);
    return old_here && new_here ? renameat(AT_FDCWD, old_here, AT_FDCWD, new_here) : -1;
}
