/* own_folder.c - see own_folder.h. */
#include "lab/jobs/own_folder.h"
#include <dirent.h>
#include <fts.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "kernel/xalloc.h"

/* Has the file changed after that time? What is no file has not. */
static bool is_later(const char *path, const struct timespec *time)
{
    struct stat st;
    return time && !stat(path, &st) && S_ISREG(st.st_mode) &&
           (st.st_ctim.tv_sec != time->tv_sec ? st.st_ctim.tv_sec > time->tv_sec
                                              : st.st_ctim.tv_nsec > time->tv_nsec);
}

static void link_one(const char *path, const char *like, const char *name, const struct timespec *until)
{
    char *from = xasprintf("%s/%s", like, name), *to = xasprintf("%s/%s", path, name);
    int made = is_later(from, until) ? 0 : symlink(from, to);
    (void)made; /* without the link the program misses the file, and says so */
    free(from);
    free(to);
}

bool own_folder_make(const char *path, const char *like, const char *except, const struct timespec *until)
{
    DIR *all = mkdir(path, 0700) ? NULL : opendir(like);
    if (!all)
        return false;
    for (struct dirent *e; (e = readdir(all));)
        if (strcmp(e->d_name, ".") && strcmp(e->d_name, "..") && (!except || strcmp(e->d_name, except)))
            link_one(path, like, e->d_name, until);
    closedir(all);
    return true;
}

void own_folder_remove(const char *path)
{
    char *const roots[] = {(char *)(uintptr_t)path, NULL};
    FTS *tree = fts_open(roots, FTS_PHYSICAL | FTS_NOCHDIR, NULL);
    if (!tree)
        return;
    for (FTSENT *e; (e = fts_read(tree));)
        if (e->fts_info == FTS_DP)
            rmdir(e->fts_path);
        else if (e->fts_info != FTS_D)
            unlink(e->fts_path);
    fts_close(tree);
}
