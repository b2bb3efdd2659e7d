/* program_file.c - see program_file.h. */
#include "files/program_file.h"
#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "kernel/xalloc.h"

static bool begins_other(char *const *words, int count)
{
    return count > 3 && !strcmp(words[0], ":") && (!strcmp(words[1], "-n") || !strcmp(words[1], "-np"));
}

int named_program_words(char *const *words, int count)
{
    int n = 1;
    while (n < count && !begins_other(words + n, count - n))
        n++;
    return n;
}

static bool is_there(const char *path)
{
    struct stat st;
    return stat(path, &st) == 0 && !S_ISDIR(st.st_mode);
}

/* A folder, or what nobody can tell of. */
static bool may_be_there(const char *path)
{
    return access(path, F_OK) == 0 || (errno != ENOENT && errno != ENOTDIR);
}

char *program_file_find(const char *name, const char *here, const char *brought, char **error)
{
    bool whole = *name == '/';
    char *path = whole || !here ? xstrdup(name) : xasprintf("%s/%s", here, name);
    if (is_there(path))
        return path;
    char *other = whole ? NULL : xasprintf("%s/%s", brought, name);
    if (other && is_there(other)) {
        free(path);
        return other;
    }
    if (may_be_there(path)) { /* who opens it says why that is no program */
        free(other);
        return path;
    }
    *error = whole ? xasprintf("there is no program %s", path)
                   : xasprintf("there is no program %s, nor touchstone's own %s", path, other);
    free(path);
    free(other);
    return NULL;
}
