/* locks.c - locks of files, by BSD's and System V's calls. As fcntl's, they are a node's own: each node gets
 * every lock at once, whatever others have locked. */
#include <errno.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

int flock(int fd, int what)
{
    int how = what & ~LOCK_NB;
    if (fcntl(fd, F_GETFD) < 0)
        return -1;
    if (how == LOCK_SH || how == LOCK_EX || how == LOCK_UN)
        return 0;
    errno = EINVAL;
    return -1;
}

int lockf(int fd, int what, off_t bytes)
{
    struct flock l = {.l_type = what == F_ULOCK ? F_UNLCK : F_WRLCK, .l_whence = SEEK_CUR, .l_len = bytes};
    if (what == F_TEST)
        return fcntl(fd, F_GETLK, &l);
    if (what == F_ULOCK || what == F_LOCK || what == F_TLOCK)
        return fcntl(fd, F_SETLK, &l);
    errno = EINVAL;
    return -1;
}
