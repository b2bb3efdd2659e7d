/* more_files.c - calls on files that are made of other calls. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <unistd.h>
#include <utime.h>

int truncate64(const char *path, off64_t bytes)
{
    int fd = open(path, O_WRONLY);
    if (fd < 0)
        return -1;
    int answer = ftruncate64(fd, bytes), why = errno;
    close(fd);
    errno = why;
    return answer;
}

int truncate(const char *path, off_t bytes)
{
    return truncate64(path, (int32_t)bytes); /* as ftruncate */
}

int utime(const char *path, const struct utimbuf *to)
{
    struct timeval times[2] = {0};
    if (!to)
        return utimes(path, NULL);
    times[0].tv_sec = to->actime;
    times[1].tv_sec = to->modtime;
    return utimes(path, times);
}

int fdatasync(int fd)
{
    return fsync(fd);
}

ssize_t readv(int fd, const struct iovec *parts, int count)
{
    ssize_t done = 0;
    for (int i = 0; i < count; i++) {
        ssize_t n = read(fd, parts[i].iov_base, parts[i].iov_len);
        if (n < 0)
            return done ? done : -1;
        done += n;
        if ((size_t)n < parts[i].iov_len)
            break;
    }
    return done;
}
