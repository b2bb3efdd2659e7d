/* store.c - see store.h. */
#include "cfs/store.h"
#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "files/folder_make.h"
#include "guest/libc/fence.h"
#include "guest/libc/folder_names.h"
#include "kernel/xalloc.h"

struct store {
    char *dir;              /* NULL: the temporary one is not made yet */
    struct scratch scratch; /* the temporary one */
    char *failure;          /* why it cannot be made */
    struct fence *fence;    /* round the folder: links out of it are not followed */
    struct store_file *files;
    void *by_path; /* a tree of those that are not gone: tsearch() */
    uint32_t ids;
    uint32_t slots, *unused, unused_count; /* unused: of the slots that have been given out */
};

/* --- the files that it knows --- */

static int compare(const void *a, const void *b)
{
    return strcmp(((const struct store_file *)a)->path, ((const struct store_file *)b)->path);
}

static struct store_file *find(struct store *s, const char *name)
{
    const struct store_file sought = {.path = (char *)(uintptr_t)name};
    struct store_file **f = tfind(&sought, &s->by_path, compare);
    return f ? *f : NULL;
}

static void put_path(struct store *s, struct store_file *f, char *path)
{
    f->path = path;
    xchecked(tsearch(f, &s->by_path, compare));
}

static struct store_file *add(struct store *s, const char *name)
{
    struct store_file *f = xcalloc(1, sizeof *f);
    f->store = s;
    f->id = s->ids++;
    f->slot = s->unused_count ? s->unused[--s->unused_count] : s->slots++;
    f->next = s->files, f->link = &s->files;
    if (f->next)
        f->next->link = &f->next;
    s->files = f;
    put_path(s, f, xstrdup(name));
    return f;
}

static void free_file(struct store_file *f)
{
    struct store *s = f->store;
    s->unused = xreallocarray(s->unused, s->unused_count + 1, sizeof *s->unused);
    s->unused[s->unused_count++] = f->slot;
    if (f->next)
        f->next->link = f->link;
    *f->link = f->next;
    modes_free(&f->modes);
    free(f->volumes);
    free(f->path);
    free(f);
}

/* Frees a file that nobody can name or use any more. (A round of mode 4 may still name it: unison.c.) */
static void free_if_lost(struct store_file *f)
{
    if (f->gone && f->users == 0 && f->modes.group[MODE_UNISON].generation == 0)
        free_file(f);
}

static void lose_name(struct store *s, struct store_file *f)
{
    tdelete(f, &s->by_path, compare);
    f->gone = true;
    free_if_lost(f);
}

static void keep(void *f)
{
    (void)f;
}

/* --- making and freeing --- */

struct store *store_new(const char *dir, char **error)
{
    struct store *s = xcalloc(1, sizeof *s);
    s->fence = fence_empty();
    if (!dir)
        return s;
    struct stat st;
    s->dir = xstrdup(dir);
    if ((mkdir(dir, 0777) && errno != EEXIST) || stat(dir, &st) || !S_ISDIR(st.st_mode) ||
        !fence_add(s->fence, dir, true)) {
        *error = xasprintf("--cfs %s: %s", dir, strerror(errno == EEXIST ? ENOTDIR : errno));
        store_free(s);
        return NULL;
    }
    return s;
}

void store_free(struct store *s)
{
    if (!s)
        return;
    tdestroy(s->by_path, keep);
    while (s->files) {
        if (s->files->users)
            close(s->files->host);
        free_file(s->files);
    }
    scratch_remove(&s->scratch);
    fence_free(s->fence);
    free(s->unused);
    free(s->failure);
    free(s->dir);
    free(s);
}

/* --- paths --- */

/* "/cfs//a/./b", or "/pfs//a/./b" -> "a/b". 0; EACCES: the path leads out of /cfs; or ENAMETOOLONG. */
static int within(const char *path, char *buf, size_t size)
{
    char *end = buf;
    for (path += 4; *path;) {
        size_t n = strcspn(path, "/");
        bool up = n == 2 && memcmp(path, "..", 2) == 0, same = n == 0 || (n == 1 && *path == '.');
        if (up || (size_t)(end - buf) + n + 2 > size)
            return up ? EACCES : ENAMETOOLONG;
        if (!same) {
            if (end > buf)
                *end++ = '/';
            memcpy(end, path, n);
            end += n;
        }
        path += n + (path[n] == '/');
    }
    *end = 0;
    return 0;
}

/* The folder is made when it is first needed, so that programs without files leave no trace. */
static bool have_dir(struct store *s)
{
    if (s->dir || s->failure)
        return s->dir;
    s->scratch = folder_scratch("touchstone-cfs", &s->failure);
    if (!s->scratch.path)
        return false;
    s->dir = xstrdup(s->scratch.path);
    return fence_add(s->fence, s->dir, true);
}

const char *store_failure(const struct store *s)
{
    return s->failure;
}

static int host_path(struct store *s, const char *name, char *buf, size_t size)
{
    if (!have_dir(s))
        return EIO;
    return (size_t)snprintf(buf, size, "%s/%s", s->dir, name) < size ? 0 : ENAMETOOLONG;
}

/* The error number of what the fence answered. What leads out of the folder may not be used, by whatever
 * name. */
static int error_of(int answer)
{
    return answer == FENCE_REFUSED ? EACCES : answer < 0 ? errno : 0;
}

/* Makes the folders above the last name of path, below the store's own. */
static void make_folders(const struct store *s, char *path)
{
    for (char *slash = strchr(path + strlen(s->dir) + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = 0;
        fence_mkdir(s->fence, path, 0777);
        *slash = '/';
    }
}

/* --- opening --- */

/* Why a file could not be opened for writing: may it still be read? */
static bool is_only_read(int why)
{
    return why == EACCES || why == EROFS || why == EPERM;
}

/* Opens the host's file of a file that has no users. */
static int open_host(struct store *s, struct store_file *f, int flags, mode_t permissions)
{
    char path[PATH_MAX];
    struct stat st;
    int error = host_path(s, f->path, path, sizeof path);
    if (error)
        return error;
    if (flags & O_CREAT)
        make_folders(s, path);
    int how = (flags & (O_CREAT | O_EXCL)) | O_CLOEXEC;
    f->host = fence_open(s->fence, path, O_RDWR | how, permissions);
    f->writable = f->host >= 0;
    if (f->host == -1 && is_only_read(errno))
        f->host = fence_open(s->fence, path, O_RDONLY | how, permissions);
    if (f->host < 0)
        return error_of(f->host);
    fstat(f->host, &st);
    if (S_ISDIR(st.st_mode)) {
        close(f->host);
        return EISDIR;
    }
    f->size = (uint64_t)st.st_size;
    return 0;
}

static int truncate_file(struct store *s, struct store_file *f)
{
    if (ftruncate(f->host, 0))
        return errno;
    f->size = 0;
    f->id = s->ids++;
    return 0;
}

int store_open(struct store *s, const char *path, int flags, mode_t permissions, struct store_file **file)
{
    char name[PATH_MAX];
    int error = within(path, name, sizeof name);
    if (error)
        return error;
    struct store_file *f = find(s, name);
    if (f && f->users && (flags & O_CREAT) && (flags & O_EXCL))
        return EEXIST;
    bool is_known = f;
    if (!f)
        f = add(s, name);
    error = f->users ? 0 : open_host(s, f, flags, permissions);
    if (error && !is_known)
        lose_name(s, f);
    if (error)
        return error;
    f->users++;
    if ((flags & O_ACCMODE) != O_RDONLY && !f->writable)
        error = EACCES;
    else if (flags & O_TRUNC && f->size)
        error = truncate_file(s, f);
    if (error)
        store_release(f);
    else
        *file = f;
    return error;
}

void store_hold(struct store_file *f)
{
    f->users++;
}

void store_release(struct store_file *f)
{
    assert(f->users > 0);
    if (--f->users > 0)
        return;
    close(f->host);
    free_if_lost(f);
}

/* --- names --- */

/* Finds a path's name within the file system, and on the host, in PATH_MAX bytes each. 0, or an error. */
static int find_names(struct store *s, const char *path, char *name, char *host)
{
    int error = within(path, name, PATH_MAX);
    return error ? error : host_path(s, name, host, PATH_MAX);
}

int store_unlink(struct store *s, const char *path)
{
    char name[PATH_MAX], host[PATH_MAX];
    int error = find_names(s, path, name, host);
    if (error)
        return error;
    if (!*name)
        return EBUSY; /* the folder of all */
    error = error_of(fence_unlink(s->fence, host));
    if (error == EISDIR)
        error = error_of(fence_rmdir(s->fence, host));
    if (error)
        return error;
    struct store_file *f = find(s, name);
    if (f)
        lose_name(s, f);
    return 0;
}

/* Is path this name, or below a folder of this name? */
static bool is_or_is_below(const char *path, const char *name)
{
    size_t n = strlen(name);
    return strncmp(path, name, n) == 0 && (path[n] == 0 || path[n] == '/');
}

/* What had the name `to` is gone; the file `from`, or the files in that folder, have new names. */
static void rename_files(struct store *s, const char *from, const char *to)
{
    for (struct store_file *f = s->files, *next; f; f = next) {
        next = f->next;
        if (!f->gone && is_or_is_below(f->path, to))
            lose_name(s, f);
    }
    for (struct store_file *f = s->files; f; f = f->next)
        if (!f->gone && is_or_is_below(f->path, from)) {
            char *old = f->path;
            tdelete(f, &s->by_path, compare);
            put_path(s, f, xasprintf("%s%s", to, old + strlen(from)));
            free(old);
        }
}

int store_rename(struct store *s, const char *from, const char *to)
{
    char name[PATH_MAX], new_name[PATH_MAX], host[PATH_MAX], new_host[PATH_MAX];
    int error = find_names(s, from, name, host);
    if (!error)
        error = find_names(s, to, new_name, new_host);
    if (error)
        return error;
    if (!*name || !*new_name)
        return EBUSY;
    make_folders(s, new_host);
    error = error_of(fence_rename(s->fence, host, new_host));
    if (!error && strcmp(name, new_name) != 0)
        rename_files(s, name, new_name);
    return error;
}

/* A number that tells a file from others, the same on any computer: its name's hash (FNV-1a). */
static ino_t identity(const char *name)
{
    uint64_t h = 0xcbf29ce484222325u;
    for (; *name; name++)
        h = (h ^ (unsigned char)*name) * 0x100000001b3u;
    return (ino_t)h;
}

int store_stat(struct store *s, const char *path, struct stat *st)
{
    char name[PATH_MAX], host[PATH_MAX];
    int error = find_names(s, path, name, host);
    if (!error)
        error = error_of(fence_stat(s->fence, host, st));
    if (error)
        return error;
    st->st_ino = identity(name);
    return 0;
}

int store_names(struct store *s, const char *path, char **names)
{
    char name[PATH_MAX], host[PATH_MAX];
    int error = find_names(s, path, name, host);
    if (error)
        return error;
    int fd = fence_open(s->fence, host, O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0);
    if (fd < 0)
        return error_of(fd);
    *names = folder_names(fd);
    return *names ? 0 : errno;
}

/* --- bytes --- */

int store_read(struct store_file *f, uint64_t at, void *buf, size_t bytes)
{
    size_t done = 0;
    while (done < bytes) {
        ssize_t n = pread(f->host, (char *)buf + done, bytes - done, (off_t)(at + done));
        if (n < 0 && errno != EINTR)
            return errno;
        if (n == 0)
            break;
        done += n > 0 ? (size_t)n : 0;
    }
    memset((char *)buf + done, 0, bytes - done);
    return 0;
}

int store_write(struct store_file *f, uint64_t at, const void *buf, size_t bytes)
{
    for (size_t done = 0; done < bytes;) {
        ssize_t n = pwrite(f->host, (const char *)buf + done, bytes - done, (off_t)(at + done));
        if (n < 0 && errno != EINTR)
            return errno;
        done += n > 0 ? (size_t)n : 0;
    }
    if (at + bytes > f->size)
        f->size = at + bytes;
    return 0;
}

int store_grow(struct store_file *f, uint64_t size)
{
    if (size <= f->size)
        return 0;
    if (ftruncate(f->host, (off_t)size))
        return errno;
    f->size = size;
    return 0;
}

int store_cut(struct store_file *f, uint64_t size)
{
    if (size != f->size && ftruncate(f->host, (off_t)size))
        return errno;
    f->size = size;
    return 0;
}

int store_fstat(struct store_file *f, struct stat *st)
{
    if (fstat(f->host, st))
        return errno;
    st->st_ino = identity(f->path);
    return 0;
}
