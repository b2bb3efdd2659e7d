/* study_folder.c - see study_folder.h. */
#include "lab/serve/study_folder.h"
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

int study_folder_open(int in, const char *path, bool make)
{
    int flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC | (in == AT_FDCWD ? 0 : O_NOFOLLOW);
    if (make && mkdirat(in, path, 0777) != 0 && errno != EEXIST)
        return -1;
    return openat(in, path, flags);
}

int study_folder_file(int folder, const char *name)
{
    struct stat st;
    int fd = openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (fd >= 0 && (fstat(fd, &st) != 0 || !S_ISREG(st.st_mode))) {
        close(fd);
        errno = EINVAL;
        return -1;
    }
    return fd;
}

json_t *study_folder_json(int folder, const char *name)
{
    int fd = study_folder_file(folder, name);
    json_t *j = fd >= 0 ? json_loadfd(fd, 0, NULL) : NULL;
    if (fd >= 0)
        close(fd);
    if (json_is_object(j))
        return j;
    json_decref(j);
    return NULL;
}

static bool same(const struct stat *a, const struct stat *b)
{
    return a->st_ino == b->st_ino && a->st_size == b->st_size && a->st_mtim.tv_sec == b->st_mtim.tv_sec &&
           a->st_mtim.tv_nsec == b->st_mtim.tv_nsec;
}

bool watched_file_changed(struct watched_file *f, int folder)
{
    struct stat now;
    if (fstatat(folder, f->name, &now, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(now.st_mode))
        memset(&now, 0, sizeof now);
    bool changed = !same(&now, &f->seen);
    f->seen = now;
    return changed;
}
