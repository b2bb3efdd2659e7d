/* point_locks.c - see point_locks.h. The bytes of DIR/lock serve as locks: byte 0 for the session, 1 for the
 * report, from 2 on for points. The file's text names the session and the process that began it. */
#include "lab/jobs/point_locks.h"
#include "kernel/xalloc.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { SESSION, REPORT, POINTS, TRIES = 100, MAX_TEXT = 512 };

struct point_locks {
    int fd;
    off_t *held; /* the bytes of the points that are locked: the system would grant them again */
    size_t held_count;
};

/* Sets or releases the lock on a byte. False if another process has it. */
static bool lock(const struct point_locks *c, off_t byte, short type)
{
    struct flock one = {.l_type = type, .l_whence = SEEK_SET, .l_start = byte, .l_len = 1};
    return fcntl(c->fd, F_OFD_SETLK, &one) == 0;
}

/* Two points whose digests agree in 62 bits share a lock: one would only wait for the other. */
static off_t byte_of(struct digest key)
{
    return POINTS + (off_t)(key.high >> 2);
}

static bool write_owner(const struct point_locks *c, const char *session)
{
    char host[128] = "", text[MAX_TEXT];
    gethostname(host, sizeof host - 1);
    int size = snprintf(text, sizeof text, "%s\nprocess %ld on %s\n", session, (long)getpid(), host);
    return size < MAX_TEXT && ftruncate(c->fd, 0) == 0 && pwrite(c->fd, text, (size_t)size, 0) == size;
}

/* Does the folder belong to this session? Sets who to the process that began the folder's session. */
static bool is_ours(const struct point_locks *c, const char *session, char who[MAX_TEXT])
{
    char text[MAX_TEXT];
    ssize_t size = pread(c->fd, text, sizeof text - 1, 0);
    text[size > 0 ? size : 0] = '\0';
    char *end = strchr(text, '\n');
    snprintf(who, MAX_TEXT, "%.*s", end ? (int)strcspn(end + 1, "\n") : 0, end ? end + 1 : "");
    if (end)
        *end = '\0';
    return *session && end && strcmp(text, session) == 0;
}

/* The first process of a session locks the byte exclusively while it writes the session's name; then all its
 * processes share the lock. */
static bool enter(const struct point_locks *c, const char *dir, const char *session, char **error)
{
    static const struct timespec moment = {.tv_nsec = 50000000};
    char who[MAX_TEXT] = "";
    for (int i = 0; i < TRIES; i++) {
        if (lock(c, SESSION, F_WRLCK))
            return (write_owner(c, session) && lock(c, SESSION, F_RDLCK)) ||
                   (*error = xasprintf("%s/lock cannot be written: %m", dir), false);
        if (lock(c, SESSION, F_RDLCK)) {
            if (is_ours(c, session, who))
                return true;
            lock(c, SESSION, F_UNLCK);
            break;
        }
        nanosleep(&moment, NULL);
    }
    *error = xasprintf("%s is in use by another study (%s); wait for its end, or give another folder with -o",
                       dir, *who ? who : "starting");
    return false;
}

struct point_locks *point_locks_enter(const char *dir, const char *session, char **error)
{
    struct point_locks *c = xcalloc(1, sizeof *c);
    char *path = xasprintf("%s/lock", dir);
    c->fd = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (c->fd < 0)
        *error = xasprintf("%s cannot be opened: %m", path);
    free(path);
    if (c->fd >= 0 && enter(c, dir, session, error))
        return c;
    point_locks_leave(c);
    return NULL;
}

void point_locks_leave(struct point_locks *c)
{
    if (!c)
        return;
    if (c->fd >= 0)
        close(c->fd);
    free(c->held);
    free(c);
}

bool point_locks_are_held(int folder)
{
    struct flock one = {.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = SESSION, .l_len = 1};
    int fd = openat(folder, "lock", O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    bool held = fd >= 0 && fcntl(fd, F_OFD_GETLK, &one) == 0 && one.l_type != F_UNLCK;
    if (fd >= 0)
        close(fd);
    return held;
}

bool point_locks_take(struct point_locks *c, struct digest key)
{
    off_t byte = byte_of(key);
    for (size_t i = 0; i < c->held_count; i++)
        if (c->held[i] == byte)
            return false;
    if (!lock(c, byte, F_WRLCK))
        return false;
    c->held = xgrown(c->held, c->held_count, sizeof *c->held);
    c->held[c->held_count++] = byte;
    return true;
}

void point_locks_release(struct point_locks *c, struct digest key)
{
    off_t byte = byte_of(key);
    size_t kept = 0;
    for (size_t i = 0; i < c->held_count; i++)
        if (c->held[i] != byte)
            c->held[kept++] = c->held[i];
    c->held_count = kept;
    lock(c, byte, F_UNLCK);
}

bool point_locks_take_report(struct point_locks *c)
{
    return lock(c, REPORT, F_WRLCK);
}
