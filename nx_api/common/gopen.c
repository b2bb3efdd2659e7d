/* gopen.c - opening a file on all nodes: the first creates it, so that the others find it. */
#include <fcntl.h>
#include <nx.h>

/* Opens on this node and sets the I/O mode. An error ends the process, as gopen's. The back end serves it. */
int nx_gopen_one(const char *path, int flags, int iomode, unsigned permissions);
/* Returns -1 with errno instead. */
int _nx_gopen_one(const char *path, int flags, int iomode, unsigned permissions);

int gopen(const char *path, int flags, int iomode, unsigned permissions)
{
    int fd = -1;
    if (mynode() == 0)
        fd = nx_gopen_one(path, flags, iomode, permissions);
    gsync();
    if (mynode() != 0)
        fd = nx_gopen_one(path, flags & ~(O_CREAT | O_EXCL | O_TRUNC), iomode, permissions);
    gsync();
    return fd;
}

int _gopen(const char *path, int flags, int iomode, unsigned permissions)
{
    int fd = -1, error = 0;
    if (mynode() == 0 && (fd = _nx_gopen_one(path, flags, iomode, permissions)) < 0)
        error = errno;
    gsync();
    if (mynode() != 0 &&
        (fd = _nx_gopen_one(path, flags & ~(O_CREAT | O_EXCL | O_TRUNC), iomode, permissions)) < 0)
        error = errno;
    gsync();
    errno = error ? error : errno;
    return fd;
}
