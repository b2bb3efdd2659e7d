/* more_files.c - calls on files that are made of other calls. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

int truncate(const char *path, off_t bytes)
{
    int fd = open(path, O_WRONLY);
    if (fd < 0)
        return -1;
    int answer = ftruncate(fd, bytes), why = errno;
    close(fd);
    errno = why;
    return answer;
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
