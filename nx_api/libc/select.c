/* select.c - waiting for files to be ready, as BSD's select and System V's poll do. A node's files always
 * are: what reads or writes them waits itself, or finds their end. With none to wait for, the time passes. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/select.h>
#include <time.h>
#include <unistd.h>

static int is_open(int fd)
{
    int before = errno, open = fcntl(fd, F_GETFD) >= 0;
    errno = before;
    return open;
}

/* seconds < 0: for ever, which ends as pause() does */
static int wait_for(long long seconds, long long nanoseconds)
{
    if (seconds < 0)
        return pause();
    struct timespec t = {.tv_sec = seconds, .tv_nsec = nanoseconds};
    return nanosleep(&t, NULL);
}

/* How many of a set are ready; -1: one is not open. */
static int count_ready(int most, const fd_set *set)
{
    int ready = 0;
    for (int fd = 0; set && fd < most; fd++)
        if (FD_ISSET(fd, set)) {
            if (!is_open(fd))
                return -1;
            ready++;
        }
    return ready;
}

/* Sets errno; -1 if a file is not open, or the number of files that are ready. Nothing is exceptional. */
static int look(int most, fd_set *reads, fd_set *writes, fd_set *exceptions)
{
    if (most < 0) {
        errno = EINVAL;
        return -1;
    }
    most = most < FD_SETSIZE ? most : FD_SETSIZE; /* a set has no more */
    int in = count_ready(most, reads), out = count_ready(most, writes), other = count_ready(most, exceptions);
    if (in < 0 || out < 0 || other < 0) {
        errno = EBADF;
        return -1;
    }
    if (exceptions)
        FD_ZERO(exceptions);
    return in + out;
}

int select(int most, fd_set *restrict reads, fd_set *restrict writes, fd_set *restrict exceptions,
           struct timeval *restrict limit)
{
    int ready = look(most, reads, writes, exceptions);
    if (ready)
        return ready;
    if (limit && (limit->tv_sec < 0 || limit->tv_usec < 0 || limit->tv_usec >= 1000000)) {
        errno = EINVAL;
        return -1;
    }
    int answer = limit ? wait_for(limit->tv_sec, limit->tv_usec * 1000) : wait_for(-1, 0);
    if (limit)
        *limit = (struct timeval){0}; /* what was left */
    return answer;
}

int pselect(int most, fd_set *restrict reads, fd_set *restrict writes, fd_set *restrict exceptions,
            const struct timespec *restrict limit, const sigset_t *restrict mask)
{
    int ready = look(most, reads, writes, exceptions);
    (void)mask; /* signals do not come */
    if (ready)
        return ready;
    if (limit && limit->tv_sec < 0) {
        errno = EINVAL;
        return -1;
    }
    return limit ? wait_for(limit->tv_sec, limit->tv_nsec) : wait_for(-1, 0);
}

int poll(struct pollfd *files, nfds_t count, int milliseconds)
{
    enum { READY = POLLIN | POLLOUT | POLLRDNORM | POLLWRNORM };
    int ready = 0;
    for (nfds_t i = 0; i < count; i++) {
        struct pollfd *f = &files[i];
        f->revents = f->fd < 0 ? 0 : is_open(f->fd) ? (short)(f->events & READY) : POLLNVAL;
        ready += f->revents != 0;
    }
    if (ready || milliseconds == 0)
        return ready;
    return milliseconds < 0 ? wait_for(-1, 0)
                            : wait_for(milliseconds / 1000, milliseconds % 1000 * 1000000LL);
}
