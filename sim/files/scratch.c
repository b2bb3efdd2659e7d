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
#include <time.h>
#include <unistd.h>

/* A younger folder may have been made, but not locked yet. */
enum { YOUNG_S = 60 };

static int remove_one(const char *path, const struct stat *st, int kind, struct FTW *at)
{
    (void)st, (void)kind, (void)at;
    return remove(path), 0;
}

static void remove_all(const char *path)
{
    nftw(path, remove_one, 16, FTW_DEPTH | FTW_PHYS);
}

/* The locked folder's descriptor; -1 if another process has the lock. */
static int lock(const char *path)
{
    int fd = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (fd >= 0 && flock(fd, LOCK_EX | LOCK_NB) == 0)
        return fd;
    if (fd >= 0)
        close(fd);
    return -1;
}

static void remove_if_left(const char *path)
{
    struct stat st;
    int fd = lock(path);
    if (fd < 0)
        return;
    if (fstat(fd, &st) == 0 && st.st_uid == geteuid() && time(NULL) - st.st_mtime > YOUNG_S)
        remove_all(path);
    close(fd);
}

/* Is entry NAME-XXXXXX? */
static bool is_named(const char *entry, const char *name)
{
    size_t length = strlen(name);
    return strncmp(entry, name, length) == 0 && entry[length] == '-' && strlen(entry) == length + 7;
}

static void remove_left(const char *folder, const char *name)
{
    DIR *d = opendir(folder);
    for (struct dirent *e; d && (e = readdir(d));)
        if (is_named(e->d_name, name)) {
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
    remove_left(folder, name);
    char *path = xasprintf("%s/%s-XXXXXX", folder, name);
    if (!mkdtemp(path)) {
        int why = errno;
        free(path);
        errno = why;
        return (struct scratch){NULL, -1};
    }
    return (struct scratch){path, lock(path)};
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
