/* dirent.c - folders, as POSIX reads them: all names are taken when a folder is opened, in alphabetical
 * order, and so they are read. */
#define _GNU_SOURCE
#include <dirent.h>
#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

int nx_folder_names(const char *path, char **list); /* sim/guest/libc/folder_names.c */

struct __dirstream {
    char *names;       /* of each entry its kind and 1, its name, 0; then a 0 */
    const char *next;  /* the entry to be read */
    char *path;        /* for rewinddir */
    struct dirent now; /* what readdir has answered */
};

DIR *opendir(const char *path)
{
    DIR *d = calloc(1, sizeof *d);
    if (!d)
        return NULL;
    d->path = strdup(path);
    if (!d->path || (*path ? nx_folder_names(path, &d->names) : (errno = ENOENT, -1)) < 0) {
        free(d->path);
        free(d);
        return NULL;
    }
    d->next = d->names;
    return d;
}

/* A number that is the same on any computer, and never 0: made of the name, not that of stat. */
static ino_t number_of(const char *name)
{
    unsigned hash = 2166136261u;
    for (; *name; name++)
        hash = (hash ^ (unsigned char)*name) * 16777619u;
    return hash ? hash : 1;
}

struct dirent *readdir(DIR *d)
{
    struct dirent *e = &d->now;
    if (!*d->next)
        return NULL;
    e->d_type = (unsigned char)(*d->next - 1);
    strncpy(e->d_name, d->next + 1, sizeof e->d_name - 1);
    e->d_ino = number_of(e->d_name);
    e->d_reclen = sizeof *e;
    d->next += strlen(d->next) + 1;
    e->d_off = d->next - d->names;
    return e;
}

int readdir_r(DIR *d, struct dirent *to, struct dirent **answer)
{
    struct dirent *e = readdir(d);
    *answer = e ? memcpy(to, e, sizeof *to) : NULL;
    return 0;
}

/* Reads the folder again, as POSIX says; if that fails, as it was. */
void rewinddir(DIR *d)
{
    char *names;
    int before = errno;
    if (nx_folder_names(d->path, &names) == 0) {
        free(d->names);
        d->names = names;
    }
    errno = before;
    d->next = d->names;
}

ssize_t telldir(DIR *d)
{
    return d->next - d->names;
}

void seekdir(DIR *d, ssize_t place)
{
    d->next = d->names + place;
}

int closedir(DIR *d)
{
    free(d->names);
    free(d->path);
    free(d);
    return 0;
}

int alphasort(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

/* So many bytes of an entry hold all of it. */
static struct dirent *copy_of(const struct dirent *e)
{
    size_t bytes = offsetof(struct dirent, d_name) + strlen(e->d_name) + 1;
    struct dirent *copy = malloc((bytes + 15) / 16 * 16);
    return copy ? memcpy(copy, e, bytes) : NULL;
}

static int fail(DIR *d, struct dirent **all, int count)
{
    while (count > 0)
        free(all[--count]);
    free(all);
    closedir(d);
    errno = ENOMEM;
    return -1;
}

int scandir(const char *path, struct dirent ***answer, int (*wanted)(const struct dirent *),
            int (*order)(const struct dirent **, const struct dirent **))
{
    DIR *d = opendir(path);
    struct dirent **all = NULL, *e;
    int count = 0, room = 0;
    if (!d)
        return -1;
    while ((e = readdir(d))) {
        if (wanted && !wanted(e))
            continue;
        if (count == room) {
            room = room ? 2 * room : 16;
            struct dirent **more = realloc(all, (size_t)room * sizeof(struct dirent *));
            if (!more)
                return fail(d, all, count);
            all = more;
        }
        if (!(all[count] = copy_of(e)))
            return fail(d, all, count);
        count++;
    }
    closedir(d);
    if (count && order)
        qsort(all, (size_t)count, sizeof(struct dirent *), (int (*)(const void *, const void *))order);
    *answer = all;
    return count;
}

/* By the names of headers with -D_FILE_OFFSET_BITS=64. */
__asm__(".globl readdir64\n.set readdir64, readdir\n"
        ".globl readdir64_r\n.set readdir64_r, readdir_r\n"
        ".globl alphasort64\n.set alphasort64, alphasort\n"
        ".globl scandir64\n.set scandir64, scandir");
