/* at_offset.c - reading and writing at a place of a file, whose pointer stays: by calls that move it. */
#include <unistd.h>

/* Moves the pointer to a place. Returns where it was; -1: the file has none, or the place is none. */
static off_t begin(int fd, off_t place)
{
    off_t before = lseek(fd, 0, SEEK_CUR);
    return before < 0 || lseek(fd, place, SEEK_SET) < 0 ? -1 : before;
}

ssize_t pread(int fd, void *to, size_t bytes, off_t place)
{
    off_t before = begin(fd, place);
    if (before < 0)
        return -1;
    ssize_t done = read(fd, to, bytes);
    lseek(fd, before, SEEK_SET);
    return done;
}

ssize_t pwrite(int fd, const void *from, size_t bytes, off_t place)
{
    off_t before = begin(fd, place);
    if (before < 0)
        return -1;
    ssize_t done = write(fd, from, bytes);
    lseek(fd, before, SEEK_SET);
    return done;
}
