/* folder_make.c - see folder_make.h. */
#include "files/folder_make.h"
#include "kernel/xalloc.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

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

struct scratch folder_scratch(const char *name, char **error)
{
    struct scratch s = scratch_new(name);
    const char *tmp = getenv("TMPDIR");
    if (s.path)
        return s;
    *error =
        tmp && *tmp
            ? xasprintf(
                  "no folder can be made in TMPDIR=%s: %m; set TMPDIR to a folder that you can write to", tmp)
            : xasprintf("no folder can be made in /tmp: %m; set TMPDIR to a folder that you can write to");
    return s;
}
