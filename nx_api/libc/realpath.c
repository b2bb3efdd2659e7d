/* realpath.c - a path without links, "." and "..". */
#define _GNU_SOURCE
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_LINKS = 40 };

static int fail(int why)
{
    errno = why;
    return -1;
}

/* A link: what is still to be resolved begins with what it says. */
static int follow(char *made, char *rest)
{
    char link[PATH_MAX], more[PATH_MAX];
    ssize_t length = readlink(made, link, sizeof link - 1);
    if (length < 0)
        return -1;
    link[length] = 0;
    if (snprintf(more, sizeof more, "%s/%s", link, rest) >= PATH_MAX)
        return fail(ENAMETOOLONG);
    strcpy(rest, more);
    if (*link == '/')
        *made = 0;
    else
        *strrchr(made, '/') = 0;
    return 0;
}

/* made: absolute, without a slash at its end; rest: what follows. Both have PATH_MAX bytes. */
static int resolve(char *made, char *rest)
{
    struct stat st;
    for (int links = 0; *rest;) {
        size_t length = strcspn(rest, "/"), before = strlen(made);
        char name[PATH_MAX];
        memcpy(name, rest, length);
        name[length] = 0;
        int last = !rest[length];
        memmove(rest, rest + length + !last, strlen(rest + length + !last) + 1);
        if (!length || !strcmp(name, "."))
            continue;
        if (!strcmp(name, "..")) {
            if (before)
                *strrchr(made, '/') = 0;
            continue;
        }
        if (before + length + 2 > PATH_MAX)
            return fail(ENAMETOOLONG);
        made[before] = '/';
        strcpy(made + before + 1, name);
        if (lstat(made, &st) < 0)
            return -1;
        if (S_ISLNK(st.st_mode)) {
            if (++links > MOST_LINKS)
                return fail(ELOOP);
            if (follow(made, rest) < 0)
                return -1;
        } else if (!last && !S_ISDIR(st.st_mode)) {
            return fail(ENOTDIR);
        }
    }
    if (!*made)
        strcpy(made, "/");
    return 0;
}

char *realpath(const char *restrict path, char *restrict answer)
{
    char made[PATH_MAX] = "", rest[PATH_MAX];
    if (!path || !*path) {
        errno = path ? ENOENT : EINVAL;
        return NULL;
    }
    if (strlen(path) >= PATH_MAX) {
        errno = ENAMETOOLONG;
        return NULL;
    }
    strcpy(rest, path);
    /* (the folder in use has no links) */
    if (*path != '/' && !getcwd(made, sizeof made))
        return NULL;
    if (!strcmp(made, "/"))
        *made = 0;
    if (resolve(made, rest) < 0)
        return NULL;
    return answer ? strcpy(answer, made) : strdup(made);
}

char *canonicalize_file_name(const char *path)
{
    return realpath(path, NULL);
}
