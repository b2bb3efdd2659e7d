/* paths.c - the parts of a path, as POSIX has them in libgen.h: in the path itself, which they change, or in
 * memory of the program's own. */
#include <libgen.h>
#include <string.h>

static char *own(const char *text)
{
    static char answer[2];
    return strcpy(answer, text);
}

/* Ends the path before the slashes at its end, but for the first of a path that has only slashes. */
static size_t cut_slashes(char *path, size_t length)
{
    while (length > 1 && path[length - 1] == '/')
        length--;
    path[length] = 0;
    return length;
}

/* libgen.h calls it basename; the GNU library's own function of that name is another. */
char *__xpg_basename(char *path)
{
    if (!path || !*path)
        return own(".");
    char *slash = cut_slashes(path, strlen(path)) > 1 ? strrchr(path, '/') : NULL;
    return slash ? slash + 1 : path;
}

char *dirname(char *path)
{
    if (!path || !*path)
        return own(".");
    cut_slashes(path, strlen(path));
    char *slash = strrchr(path, '/');
    if (!slash)
        return own(".");
    cut_slashes(path, (size_t)(slash - path) + 1);
    return path;
}
