/* folder_names.c - see folder_names.h. */
#include "guest/libc/folder_names.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "kernel/xalloc.h"

struct list {
    char **entries; /* a byte for the kind, then the name */
    size_t count, bytes;
};

/* Some file systems do not tell what a file is when its folder is read. */
static unsigned char kind_of(int folder, const struct dirent *e)
{
    struct stat st;
    if (e->d_type != DT_UNKNOWN || fstatat(folder, e->d_name, &st, AT_SYMLINK_NOFOLLOW) != 0)
        return e->d_type;
    return (unsigned char)IFTODT(st.st_mode);
}

static void add(struct list *l, unsigned char kind, const char *name)
{
    size_t bytes = strlen(name) + 2;
    char *entry = xmalloc(bytes);
    entry[0] = (char)(kind + 1);
    memcpy(entry + 1, name, bytes - 1);
    l->entries = xreallocarray(l->entries, l->count + 1, sizeof *l->entries);
    l->entries[l->count++] = entry;
    l->bytes += bytes;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a + 1, *(char *const *)b + 1);
}

/* The list as one text. Frees it. */
static char *join(struct list *l)
{
    char *text = xmalloc(l->bytes + 1), *to = text;
    if (l->count > 0)
        qsort(l->entries, l->count, sizeof *l->entries, by_name);
    for (size_t i = 0; i < l->count; i++) {
        to = stpcpy(to, l->entries[i]) + 1;
        free(l->entries[i]);
    }
    *to = 0;
    free(l->entries);
    return text;
}

char *folder_names(int fd)
{
    struct list l = {NULL, 0, 0};
    DIR *d = fd < 0 ? NULL : fdopendir(fd);
    if (!d) {
        int why = errno;
        if (fd >= 0)
            close(fd);
        errno = why;
        return NULL;
    }
    const struct dirent *e;
    while (errno = 0, (e = readdir(d)) != NULL)
        add(&l, kind_of(dirfd(d), e), e->d_name);
    int why = errno;
    closedir(d);
    char *text = join(&l);
    if (why != 0) {
        free(text);
        text = NULL;
    }
    errno = why;
    return text;
}
