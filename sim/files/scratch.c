/* scratch.c - see scratch.h. */
#include "files/scratch.h"
#include "kernel/xalloc.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/* The names of all folders that touchstone makes: what a killed one leaves is removed by any other. */
static const char *const NAMES[] = {"touchstone-cfs",     "touchstone-debugger",    "touchstone-explore",
                                    "touchstone-picture", "touchstone-sensitivity", "touchstone-serve",
                                    "touchstone-study",   "touchstone-tables",      "touchstone-why"};
enum { NAME_COUNT = sizeof NAMES / sizeof *NAMES };

static int remove_one(const char *path, const struct stat *st, int kind, struct FTW *at)
{
    (void)st, (void)kind, (void)at;
    return remove(path), 0;
}

static void remove_all(const char *path)
{
    nftw(path, remove_one, 16, FTW_DEPTH | FTW_PHYS);
}

/* Locks the folder, how: flock's. -1 if that cannot be, as another process has the lock, or the file system
 * has no locks. */
static int lock(const char *path, int how)
{
    int fd = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (fd >= 0 && flock(fd, how) == 0)
        return fd;
    if (fd >= 0)
        close(fd);
    return -1;
}

/* Has the folder that was locked still that path? Between opening and locking another process may have
 * removed the folder. */
static bool is_there(const char *path, int fd)
{
    struct stat there, locked;
    return lstat(path, &there) == 0 && fstat(fd, &locked) == 0 && there.st_ino == locked.st_ino &&
           there.st_dev == locked.st_dev;
}

static void remove_if_left(const char *path)
{
    struct stat st;
    if (lstat(path, &st) || st.st_uid != geteuid())
        return;
    int fd = lock(path, LOCK_EX | LOCK_NB);
    if (fd < 0)
        return;
    if (is_there(path, fd))
        remove_all(path);
    close(fd);
}

/* Is entry NAME-XXXXXX, of a name that touchstone gives? */
static bool is_named(const char *entry)
{
    const char *dash = strrchr(entry, '-');
    for (int i = 0; dash && i < NAME_COUNT; i++)
        if (strlen(dash) == 7 && strlen(NAMES[i]) == (size_t)(dash - entry) &&
            strncmp(entry, NAMES[i], strlen(NAMES[i])) == 0)
            return true;
    return false;
}

static void remove_left(const char *folder)
{
    DIR *d = opendir(folder);
    for (struct dirent *e; d && (e = readdir(d));)
        if (is_named(e->d_name)) {
            char *path = xasprintf("%s/%s", folder, e->d_name);
            remove_if_left(path);
            free(path);
        }
    if (d)
        closedir(d);
}

struct scratch scratch_new(const char *name)
{
    const char *tmp = getenv("TMPDIR"), *folder = tmp && *tmp ? tmp : "/tmp";
    remove_left(folder);
    for (;;) {
        char *path = xasprintf("%s/%s-XXXXXX", folder, name);
        if (!mkdtemp(path)) {
            int why = errno;
            free(path);
            errno = why;
            return (struct scratch){NULL, -1};
        }
        struct scratch s = {path, lock(path, LOCK_EX)};
        if (s.lock >= 0 ? is_there(path, s.lock) : access(path, F_OK) == 0)
            return s;
        if (s.lock >= 0) /* taken for a dead process's before it was locked */
            close(s.lock);
        free(path);
    }
}

void scratch_remove(struct scratch *s)
{
    if (!s->path)
        return;
    remove_all(s->path);
    if (s->lock >= 0)
        close(s->lock);
    free(s->path);
    *s = (struct scratch){NULL, -1};
}
