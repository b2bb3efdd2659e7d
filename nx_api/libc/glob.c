/* glob.c - names of files by a pattern, as a shell's, in alphabetical order. Not there: braces, the tilde,
 * and folders read by functions of the program's. */
#define _GNU_SOURCE
#include <dirent.h>
#include <errno.h>
#include <fnmatch.h>
#include <glob.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

struct search {
    glob_t *found;
    int flags;
    int (*failed)(const char *path, int why);
};

static int add(const struct search *s, const char *path, size_t length)
{
    glob_t *g = s->found;
    size_t at = g->gl_offs + g->gl_pathc;
    char **more = realloc(g->gl_pathv, (at + 2) * sizeof *more), *copy;
    if (!more)
        return GLOB_NOSPACE;
    g->gl_pathv = more;
    more[at] = more[at + 1] = NULL;
    if (!(copy = malloc(length + 2)))
        return GLOB_NOSPACE;
    memcpy(copy, path, length);
    copy[length] = 0;
    more[at] = copy;
    g->gl_pathc++;
    return 0;
}

static int is_folder(const char *path)
{
    struct stat st;
    return stat(path, &st) == 0 && S_ISDIR(st.st_mode);
}

/* All of the pattern is used up: is there such a file? */
static int finish(const struct search *s, const char *path, size_t length)
{
    struct stat st;
    if (!length || (stat(path, &st) < 0 && lstat(path, &st) < 0))
        return 0;
    int error = add(s, path, length);
    if (!error && s->flags & GLOB_MARK && path[length - 1] != '/' && is_folder(path))
        strcat(s->found->gl_pathv[s->found->gl_offs + s->found->gl_pathc - 1], "/");
    return error;
}

static int has_magic(const char *pattern, size_t length, int flags)
{
    for (size_t i = 0; i < length; i++)
        if (strchr("*?[", pattern[i]) || (pattern[i] == '\\' && !(flags & GLOB_NOESCAPE)))
            return 1;
    return 0;
}

static int extend(const struct search *s, char *path, size_t length, const char *pattern);

/* Goes on below each name of the folder `path` that one part of the pattern fits. */
static int extend_by(const struct search *s, char *path, size_t length, const char *part, const char *rest)
{
    int answer = 0, how = FNM_PERIOD | (s->flags & GLOB_NOESCAPE ? FNM_NOESCAPE : 0);
    path[length] = 0;
    DIR *d = opendir(length ? path : ".");
    if (!d) {
        int why = errno;
        return (s->failed && s->failed(path, why)) || s->flags & GLOB_ERR ? GLOB_ABORTED : 0;
    }
    for (struct dirent *e; !answer && (e = readdir(d));) {
        size_t more = strlen(e->d_name);
        if (fnmatch(part, e->d_name, how) || length + more + 1 >= PATH_MAX)
            continue;
        strcpy(path + length, e->d_name);
        if (!*rest || is_folder(path))
            answer = extend(s, path, length + more, rest);
    }
    closedir(d);
    return answer;
}

/* path: of that length, what the pattern before `pattern` fits. */
static int extend(const struct search *s, char *path, size_t length, const char *pattern)
{
    for (; *pattern == '/' && length + 1 < PATH_MAX; pattern++)
        path[length++] = '/';
    path[length] = 0;
    if (!*pattern)
        return finish(s, path, length);
    size_t part = strcspn(pattern, "/");
    if (length + part + 1 >= PATH_MAX)
        return 0;
    if (!has_magic(pattern, part, s->flags)) {
        memcpy(path + length, pattern, part);
        return extend(s, path, length + part, pattern + part);
    }
    char own[PATH_MAX];
    memcpy(own, pattern, part);
    own[part] = 0;
    return extend_by(s, path, length, own, pattern + part);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static int prepare(glob_t *g, int flags)
{
    if (!(flags & GLOB_DOOFFS))
        g->gl_offs = 0;
    if (flags & GLOB_APPEND)
        return 0;
    g->gl_pathc = 0;
    g->gl_pathv = calloc(g->gl_offs + 1, sizeof *g->gl_pathv);
    return g->gl_pathv ? 0 : GLOB_NOSPACE;
}

int glob(const char *restrict pattern, int flags, int (*failed)(const char *, int), glob_t *restrict g)
{
    enum {
        HERE = GLOB_ERR | GLOB_MARK | GLOB_NOSORT | GLOB_DOOFFS | GLOB_NOCHECK | GLOB_APPEND | GLOB_NOESCAPE
    };
    char path[PATH_MAX];
    struct search s = {g, flags, failed};
    if (flags & ~HERE) {
        errno = ENOSYS;
        return GLOB_NOSYS;
    }
    int error = prepare(g, flags);
    size_t before = g->gl_pathc;
    if (!error)
        error = extend(&s, path, 0, pattern);
    if (!error && g->gl_pathc == before)
        return flags & GLOB_NOCHECK ? add(&s, pattern, strlen(pattern)) : GLOB_NOMATCH;
    if (g->gl_pathc > before && !(flags & GLOB_NOSORT))
        qsort(g->gl_pathv + g->gl_offs + before, g->gl_pathc - before, sizeof *g->gl_pathv, by_name);
    return error;
}

void globfree(glob_t *g)
{
    for (size_t i = 0; i < g->gl_pathc; i++)
        free(g->gl_pathv[g->gl_offs + i]);
    free(g->gl_pathv);
    g->gl_pathc = 0;
    g->gl_pathv = NULL;
}

/* By the names of headers with -D_FILE_OFFSET_BITS=64. */
__asm__(".globl glob64\n.set glob64, glob\n.globl globfree64\n.set globfree64, globfree");
