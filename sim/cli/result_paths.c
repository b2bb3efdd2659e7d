/* result_paths.c - see result_paths.h. */
#include "cli/result_paths.h"
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "files/atomic_file.h"
#include "kernel/xalloc.h"

int result_paths_count(const struct result_paths *r)
{
    int count = 0;
    for (size_t i = 0; i < RESULT_MOST_PATHS; i++)
        count += r->path[i] != NULL;
    return count;
}

int result_paths_dashes(const struct result_paths *r)
{
    int count = 0;
    for (size_t i = 0; i < RESULT_MOST_PATHS; i++)
        count += r->path[i] && !strcmp(r->path[i], "-");
    return count;
}

/* Do two paths name one entry of a folder? */
static bool is_same_entry(const char *a, const char *b)
{
    struct stat in, other;
    if (strcmp(basename(a), basename(b)) != 0)
        return false;
    char *folder = xasprintf("%.*s.", (int)(basename(a) - a), a);
    char *others = xasprintf("%.*s.", (int)(basename(b) - b), b);
    bool same = stat(folder, &in) == 0 && stat(others, &other) == 0 && in.st_ino == other.st_ino &&
                in.st_dev == other.st_dev;
    free(folder);
    free(others);
    return same;
}

/* Would two results at these paths be in one file? What a link leads to is written itself. */
static bool is_same_file(const char *a, const char *b)
{
    char at[PATH_MAX], other[PATH_MAX];
    return is_same_entry(realpath(a, at) ? at : a, realpath(b, other) ? other : b);
}

const char *result_paths_twice(const struct result_paths *r)
{
    struct stat st;
    for (size_t i = 0; i < RESULT_MOST_PATHS; i++)
        for (size_t k = 0; r->path[i] && k < i; k++)
            if (r->path[k] && is_same_file(r->path[i], r->path[k]) &&
                (stat(r->path[i], &st) != 0 || S_ISREG(st.st_mode)))
                return r->path[i];
    return NULL;
}

bool result_paths_possible(const struct result_paths *r, char **error)
{
    for (size_t i = 0; i < RESULT_MOST_PATHS; i++)
        if (r->path[i] && !atomic_file_possible(r->path[i], error))
            return false;
    return true;
}
