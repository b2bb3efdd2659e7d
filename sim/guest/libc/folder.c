/* folder.c - see folder.h. */
#include "guest/libc/folder.h"
#include <assert.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "guest/libc/file.h"
#include "guest/libc/libc_parts.h"
#include "node/node.h"
#include "guest/libc/host_errno.h"
#include "node/self.h"

const char *folder_path(struct node *n, const char *path, int slot)
{
    assert(slot >= 0 && slot < FOLDER_SLOTS);
    struct node_libc *c = libc_of(n);
    if (c->folder == NULL || *path == '/' || *path == 0)
        return path;
    free(c->whole[slot]);
    return c->whole[slot] = xasprintf("%s/%s", c->folder, path);
}

void folder_free(struct node_libc *c)
{
    free(c->folder);
    for (int i = 0; i < FOLDER_SLOTS; i++)
        free(c->whole[i]);
}

/* Takes "//", "." and ".." out of an absolute path. */
static void tidy(char *path)
{
    char *end = path;
    for (const char *from = path; *from;) {
        size_t len = strcspn(++from, "/");
        if (len == 2 && from[0] == '.' && from[1] == '.') {
            while (end > path && *--end != '/')
                ;
        } else if (len > 0 && !(len == 1 && *from == '.')) {
            *end++ = '/';
            memmove(end, from, len);
            end += len;
        }
        from += len;
    }
    if (end == path)
        *end++ = '/';
    *end = 0;
}

/* The machine's file system has no folders: any name there may be the beginning of others. */
static int check_is_folder(struct node *n, const char *path)
{
    struct stat st;
    if (file_is_simulated(path))
        return 0;
    if (file_stat(n, path, &st) != 0)
        return -1;
    if (S_ISDIR(st.st_mode))
        return 0;
    errno = ENOTDIR;
    return -1;
}

/* The folder in use, for free(); NULL with errno if it is not known. */
static char *present(struct node *n)
{
    return libc_of(n)->folder ? xstrdup(libc_of(n)->folder) : getcwd(NULL, 0);
}

int node_chdir(const char *path)
{
    struct node *n = node_self();
    char *now = *path == '/' ? NULL : present(n);
    char *to = *path == '/' ? xstrdup(path) : now ? xasprintf("%s/%s", now, path) : NULL;
    free(now);
    if (to == NULL || *path == 0 || check_is_folder(n, to) != 0) {
        int why = *path == 0 ? ENOENT : node_errno();
        free(to);
        node_set_errno(why);
        return -1;
    }
    tidy(to);
    free(libc_of(n)->folder);
    libc_of(n)->folder = to;
    return 0;
}

void *node_malloc(size_t bytes);

/* If buf is NULL, the path goes into memory of the program's own, as in glibc. */
char *node_getcwd(char *buf, size_t size)
{
    char *now = present(node_self());
    size_t bytes = now ? strlen(now) + 1 : 0;
    if (now && buf == NULL)
        buf = node_malloc(size = size > bytes ? size : bytes);
    if (now && bytes > size)
        errno = ERANGE;
    if (now == NULL || buf == NULL || bytes > size)
        buf = NULL;
    else
        memcpy(buf, now, bytes);
    int why = node_errno();
    free(now);
    node_set_errno(why);
    return buf;
}

char *node_getwd(char *buf)
{
    return node_getcwd(buf, PATH_MAX);
}

/* --- what is in a folder --- */

/* The bytes of a list of folder_names.h. */
static size_t length_of(const char *list)
{
    size_t at = 0;
    while (list[at] != 0)
        at += strlen(list + at) + 1;
    return at + 1;
}

/* What node code (nx_api/libc/dirent.c) asks for: sets *list to the folder's list, in memory of the
 * program's own, for its free(). 0, or -1 with errno. */
int node_nx_folder_names(const char *path, char **list)
{
    char *names = file_names(node_self(), path);
    if (!names)
        return -1;
    size_t bytes = length_of(names);
    *list = node_malloc(bytes);
    if (*list)
        memcpy(*list, names, bytes);
    free(names);
    if (*list)
        return 0;
    node_set_errno(ENOMEM);
    return -1;
}
