/* left_over.c - see left_over.h. */
#include "files/left_over.h"
#include "kernel/xalloc.h"
#include <dirent.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

static int remove_one(const char *path, const struct stat *st, int kind, struct FTW *at)
{
    (void)st, (void)kind, (void)at;
    return remove(path), 0;
}

void left_over_remove(const char *path)
{
    nftw(path, remove_one, 16, FTW_DEPTH | FTW_PHYS);
}

int left_over_lock(const char *path, int how)
{
    int fd = open(path, O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    if (fd >= 0 && flock(fd, how) == 0)
        return fd;
    if (fd >= 0)
        close(fd);
    return -1;
}

bool left_over_is_there(const char *path, int fd)
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
    int fd = left_over_lock(path, LOCK_EX | LOCK_NB);
    if (fd < 0)
        return;
    if (left_over_is_there(path, fd))
        left_over_remove(path);
    close(fd);
}

void left_over_remove_all(const char *folder, bool (*is_named)(const char *entry, const void *ctx),
                          const void *ctx)
{
    DIR *d = opendir(folder);
    for (struct dirent *e; d && (e = readdir(d));)
        if (is_named(e->d_name, ctx)) {
            char *path = xasprintf("%s/%s", folder, e->d_name);
            remove_if_left(path);
            free(path);
        }
    if (d)
        closedir(d);
}
