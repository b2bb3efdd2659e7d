/* large_files.c - the names of calls on files that the headers use with -D_FILE_OFFSET_BITS=64: offsets and
 * structures are the same as without, but of an offset all 64 bits count. (Of folders, they stand beside the
 * others.) */
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

/* The system's. */
long long nx_lseek(int fd, long long offset, int whence);
int nx_ftruncate(int fd, long long bytes);

int open64(const char *path, int flags, ...)
{
    va_list list;
    va_start(list, flags);
    mode_t permissions = flags & O_CREAT ? va_arg(list, mode_t) : 0;
    va_end(list);
    return open(path, flags, permissions);
}

int creat64(const char *path, mode_t permissions)
{
    return creat(path, permissions);
}

/* A number, or an address. */
int fcntl64(int fd, int what, ...)
{
    va_list list;
    va_start(list, what);
    void *argument = va_arg(list, void *);
    va_end(list);
    return fcntl(fd, what, argument);
}

off64_t lseek64(int fd, off64_t offset, int whence)
{
    return nx_lseek(fd, offset, whence);
}

int ftruncate64(int fd, off64_t bytes)
{
    return nx_ftruncate(fd, bytes);
}

int lockf64(int fd, int what, off64_t bytes)
{
    return lockf(fd, what, bytes);
}

int stat64(const char *restrict path, struct stat64 *restrict st)
{
    return stat(path, (struct stat *)st);
}

int lstat64(const char *restrict path, struct stat64 *restrict st)
{
    return lstat(path, (struct stat *)st);
}

int fstat64(int fd, struct stat64 *st)
{
    return fstat(fd, (struct stat *)st);
}

int mkstemp64(char *pattern)
{
    return mkstemp(pattern);
}

int mkostemp64(char *pattern, int flags)
{
    return mkostemp(pattern, flags);
}

FILE *fopen64(const char *restrict path, const char *restrict mode)
{
    return fopen(path, mode);
}

FILE *freopen64(const char *restrict path, const char *restrict mode, FILE *restrict f)
{
    return freopen(path, mode, f);
}

FILE *tmpfile64(void)
{
    return tmpfile();
}

int fseeko64(FILE *f, off64_t offset, int whence)
{
    return fseeko(f, offset, whence);
}

off64_t ftello64(FILE *f)
{
    return ftello(f);
}

int fgetpos64(FILE *restrict f, fpos64_t *restrict place)
{
    return fgetpos(f, (fpos_t *)place);
}

int fsetpos64(FILE *f, const fpos64_t *place)
{
    return fsetpos(f, (const fpos_t *)place);
}

int getrlimit64(__rlimit_resource_t what, struct rlimit64 *limit)
{
    return getrlimit(what, (struct rlimit *)limit);
}

int setrlimit64(__rlimit_resource_t what, const struct rlimit64 *limit)
{
    return setrlimit(what, (const struct rlimit *)limit);
}
