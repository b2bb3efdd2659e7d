/* at_offset.c - reading and writing at a place of a file, whose pointer stays: by calls that move it. */
#define _GNU_SOURCE
#include <stdint.h>
#include <unistd.h>

/* Moves the pointer to a place. Returns where it was; -1: the file has none, or the place is none. */
static off64_t begin(int fd, off64_t place)
{
    off64_t before = lseek64(fd, 0, SEEK_CUR);
    return before < 0 || lseek64(fd, place, SEEK_SET) < 0 ? -1 : before;
}

ssize_t pread64(int fd, void *to, size_t bytes, off64_t place)
{
    off64_t before = begin(fd, place);
    if (before < 0)
        return -1;
    ssize_t done = read(fd, to, bytes);
    lseek64(fd, before, SEEK_SET);
    return done;
}

ssize_t pwrite64(int fd, const void *from, size_t bytes, off64_t place)
{
    off64_t before = begin(fd, place);
    if (before < 0)
        return -1;
    ssize_t done = write(fd, from, bytes);
    lseek64(fd, before, SEEK_SET);
    return done;
}

/* As lseek, these may be called without a declaration: what is not of an int is not the place's. */
ssize_t pread(int fd, void *to, size_t bytes, off_t place)
{
    return pread64(fd, to, bytes, (int32_t)place);
}

ssize_t pwrite(int fd, const void *from, size_t bytes, off_t place)
{
    return pwrite64(fd, from, bytes, (int32_t)place);
}
