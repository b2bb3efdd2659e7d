/* folder.c - see folder.h. */
#include "study/folder.h"
#include "study/text.h"

#include <errno.h>
#include <ftw.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

bool folder_make(const char *path)
{
    char part[PATH_MAX];
    struct stat st;
    if (strlen(path) >= sizeof part)
        return errno = ENAMETOOLONG, false;
    strcpy(part, path);
    for (char *slash = part + (*part == '/'); (slash = strchr(slash, '/')); *slash++ = '/') {
        *slash = '\0';
        if (mkdir(part, 0777) != 0 && errno != EEXIST)
            return false;
    }
    if (mkdir(part, 0777) != 0 && errno != EEXIST)
        return false;
    return stat(part, &st) == 0 && (S_ISDIR(st.st_mode) || (errno = ENOTDIR, false));
}

char *folder_scratch(const char *name, char **error)
{
    const char *tmp = getenv("TMPDIR");
    char *path = text_of("%s/%s.XXXXXX", tmp && *tmp ? tmp : "/tmp", name);
    if (mkdtemp(path))
        return path;
    *error = text_of("%s cannot be made: %m", path);
    free(path);
    return NULL;
}

static int remove_one(const char *path, const struct stat *st, int kind, struct FTW *at)
{
    (void)st, (void)kind, (void)at;
    return remove(path), 0;
}

void folder_remove(const char *path)
{
    nftw(path, remove_one, 16, FTW_DEPTH | FTW_PHYS);
}
