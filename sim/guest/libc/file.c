/* file.c - see file.h. */
#include "guest/libc/file.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "guest/libc/fence.h"
#include "guest/libc/folder.h"
#include "guest/libc/folder_names.h"
#include "os/handlers.h"
#include "node/node.h"
#include "node/system.h"
#include "guest/libc/host_errno.h"
#include "os/front.h"
#include "os/gate.h"

/* --- files of this computer --- */

struct host_file {
    struct node_file base;
    int fd;
};

static int fd_of(const struct node_file *f)
{
    return ((const struct host_file *)f)->fd;
}

static ssize_t host_read(struct node_file *f, void *buf, size_t bytes)
{
    return read(fd_of(f), buf, bytes);
}

static ssize_t host_write(struct node_file *f, const void *buf, size_t bytes)
{
    size_t done = 0;
    while (done < bytes) {
        ssize_t n = write(fd_of(f), (const char *)buf + done, bytes - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return done ? (ssize_t)done : -1;
        done += (size_t)n;
    }
    return (ssize_t)done;
}

static int64_t host_seek(struct node_file *f, int64_t offset, int whence)
{
    return lseek64(fd_of(f), offset, whence);
}

static int host_stat(struct node_file *f, struct stat *st)
{
    return fence_fstat(f->node->sys->fence, fd_of(f), st);
}

static int host_truncate(struct node_file *f, int64_t size)
{
    return ftruncate(fd_of(f), size);
}

static int host_close(struct node_file *f)
{
    int r = close(fd_of(f));
    free(f);
    return r;
}

static const struct node_file_class HOST_FILE = {.read = host_read,
                                                 .write = host_write,
                                                 .seek = host_seek,
                                                 .stat = host_stat,
                                                 .truncate = host_truncate,
                                                 .close = host_close};

struct node_file *file_of_host(struct node *n, int fd, int flags)
{
    if (fd < 0)
        return NULL;
    struct host_file *f = xmalloc(sizeof *f);
    *f = (struct host_file){{.class = &HOST_FILE, .node = n, .flags = flags}, fd};
    return &f->base;
}

/* --- /cfs and /pfs on a machine without a file system, and on the host, which cannot reach one --- */

static int refuse(void)
{
    errno = ENODEV;
    return -1;
}

static struct node_file *no_open(void *ctx, struct node *n, const char *path, int flags, mode_t permissions)
{
    (void)ctx, (void)n, (void)path, (void)flags, (void)permissions;
    refuse();
    return NULL;
}

static int no_unlink(void *ctx, struct node *n, const char *path)
{
    (void)ctx, (void)n, (void)path;
    return refuse();
}

static int no_rename(void *ctx, struct node *n, const char *from, const char *to)
{
    (void)ctx, (void)n, (void)from, (void)to;
    return refuse();
}

static int no_stat(void *ctx, struct node *n, const char *path, struct stat *st)
{
    (void)ctx, (void)n, (void)path, (void)st;
    return refuse();
}

static char *no_names(void *ctx, struct node *n, const char *path)
{
    (void)ctx, (void)n, (void)path;
    refuse();
    return NULL;
}

static const struct node_fs NO_FS = {NULL, no_open, no_unlink, no_rename, no_stat, no_names};

/* --- which file system a path belongs to --- */

static const struct node_fs *fs_of(const struct node *n)
{
    return n->sys->fs && !n->is_host ? n->sys->fs : &NO_FS;
}

bool file_is_simulated(const char *path)
{
    return (strncmp(path, "/cfs", 4) == 0 || strncmp(path, "/pfs", 4) == 0) &&
           (path[4] == '/' || path[4] == 0);
}

/* A call into the machine's file system is entered and left as an NX call, with handlers masked. They are
 * unmasked before node_leave(), whose deadline must not be that of a masked program. */
static bool enter(struct node *n, const char *call)
{
    bool masked = handlers_mask(n, true);
    node_enter(n, call);
    return masked;
}

static void leave(struct node *n, bool masked)
{
    handlers_mask(n, masked);
    if (!masked)
        handlers_open(n);
    int why = node_errno();
    node_leave(n);
    node_set_errno(why);
}

/* Results of a run may depend on files of this computer, so the run's report names the files. */
static void note_host_file(struct node_system *s, const char *path)
{
    for (size_t i = 0; i < s->host_file_count; i++)
        if (strcmp(s->host_files[i], path) == 0)
            return;
    if (s->host_file_count == NODE_HOST_FILES)
        return;
    if (!s->host_files)
        s->host_files = xcalloc(NODE_HOST_FILES + 1, sizeof *s->host_files);
    s->host_files[s->host_file_count++] = xstrdup(path);
}

/* Ends the run, if the fence has refused a file of this computer; otherwise returns the answer. */
static int host_answer(struct node *n, int answer)
{
    if (answer == FENCE_REFUSED) {
        struct fence_refusal r = fence_refusal(n->sys->fence);
        n->sys->refused(n, &r);
    }
    return answer;
}

/* Makes *path one from the root. Is it a file of this computer? Then it is the node's turn, and the file is
 * noted. */
static bool is_on_host(struct node *n, const char **path)
{
    *path = folder_path(n, *path, 0);
    if (file_is_simulated(*path))
        return false;
    node_order(n);
    note_host_file(n->sys, *path);
    return true;
}

/* has_less: where the file may only be read, O_RDWR is an error that the caller has an answer to. */
static struct node_file *open_on_host(struct node *n, const char *path, int flags, mode_t permissions,
                                      bool has_less)
{
    int fd = fence_open(n->sys->fence, path, flags | O_CLOEXEC, permissions);
    if (has_less && fd == FENCE_REFUSED && (flags & O_ACCMODE) == O_RDWR &&
        fence_refusal(n->sys->fence).readable) {
        errno = EROFS;
        return NULL;
    }
    return file_of_host(n, host_answer(n, fd), flags);
}

static struct node_file *open_file(struct node *n, const char *path, int flags, mode_t permissions,
                                   bool has_less)
{
    if (is_on_host(n, &path))
        return open_on_host(n, path, flags, permissions, has_less);
    bool masked = enter(n, "open");
    struct node_file *f = fs_of(n)->open(fs_of(n)->ctx, n, path, flags, permissions);
    leave(n, masked);
    if (f)
        f->flags = flags;
    return f;
}

struct node_file *file_open(struct node *n, const char *path, int flags, mode_t permissions)
{
    return open_file(n, path, flags, permissions, false);
}

struct node_file *file_open_fortran(struct node *n, const char *path, int flags, mode_t permissions)
{
    return open_file(n, path, flags, permissions, true);
}

struct node_file *file_open_temporary(struct node *n, const char *path, int flags)
{
    if (!is_on_host(n, &path))
        return file_open(n, path, flags | O_RDWR | O_CREAT | O_EXCL, 0600);
    int fd = fence_open_temporary(n->sys->fence, path, flags | O_RDWR | O_CLOEXEC);
    return file_of_host(n, host_answer(n, fd), flags | O_RDWR);
}

int file_flags(const struct node_file *f)
{
    return f->flags & (O_ACCMODE | O_APPEND | O_NONBLOCK | O_SYNC);
}

int file_set_flags(struct node_file *f, int to)
{
    if ((to ^ f->flags) & O_APPEND) {
        errno = EINVAL;
        return -1;
    }
    f->flags = (f->flags & ~O_NONBLOCK) | (to & O_NONBLOCK);
    return 0;
}

ssize_t file_read(struct node_file *f, void *buf, size_t bytes)
{
    if (!f->class->simulated) {
        node_order(f->node);
        return f->class->read(f, buf, bytes);
    }
    bool masked = enter(f->node, "read");
    ssize_t r = f->class->read(f, buf, bytes);
    leave(f->node, masked);
    return r;
}

ssize_t file_write(struct node_file *f, const void *buf, size_t bytes)
{
    if (!f->class->simulated) {
        node_order(f->node);
        return f->class->write(f, buf, bytes);
    }
    bool masked = enter(f->node, "write");
    ssize_t r = f->class->write(f, buf, bytes);
    leave(f->node, masked);
    return r;
}

int64_t file_seek(struct node_file *f, int64_t offset, int whence)
{
    if (!f->class->simulated) {
        if (whence == SEEK_END)
            node_order(f->node); /* other nodes may have moved the end */
        return f->class->seek(f, offset, whence);
    }
    bool masked = enter(f->node, "lseek");
    int64_t r = f->class->seek(f, offset, whence);
    leave(f->node, masked);
    return r;
}

int file_fstat(struct node_file *f, struct stat *st)
{
    if (!f->class->simulated) {
        node_order(f->node);
        return f->class->stat(f, st);
    }
    bool masked = enter(f->node, "fstat");
    int r = f->class->stat(f, st);
    leave(f->node, masked);
    return r;
}

int file_truncate(struct node_file *f, int64_t size)
{
    if (!f->class->simulated) {
        node_order(f->node);
        return f->class->truncate(f, size);
    }
    bool masked = enter(f->node, "ftruncate");
    int r = f->class->truncate(f, size);
    leave(f->node, masked);
    return r;
}

static int let_go(struct node_file *f)
{
    if (f->more == 0)
        return f->class->close(f);
    f->more--;
    return 0;
}

int file_close(struct node_file *f)
{
    struct node *n = f->node;
    if (!f->class->simulated) {
        node_order(n);
        return let_go(f);
    }
    bool masked = enter(n, "close");
    node_spend(n, n->sys->cfg->call_ps);
    int r = let_go(f);
    leave(n, masked);
    return r;
}

void file_drop(struct node_file *f)
{
    let_go(f);
}

/* --- names --- */

int file_stat(struct node *n, const char *path, struct stat *st)
{
    if (is_on_host(n, &path))
        return host_answer(n, fence_stat(n->sys->fence, path, st));
    bool masked = enter(n, "stat");
    int r = fs_of(n)->stat(fs_of(n)->ctx, n, path, st);
    leave(n, masked);
    return r;
}

int file_stat_within(struct node *n, const char *path, struct stat *st)
{
    if (!is_on_host(n, &path))
        return fs_of(n)->stat(fs_of(n)->ctx, n, path, st);
    return host_answer(n, fence_stat(n->sys->fence, path, st));
}

/* The machine's file system has no links. */
int file_lstat(struct node *n, const char *path, struct stat *st)
{
    if (!is_on_host(n, &path))
        return file_stat(n, path, st);
    return host_answer(n, fence_lstat(n->sys->fence, path, st));
}

/* The machine's file system has no links, so none can be read there. */
ssize_t file_readlink(struct node *n, const char *path, char *buf, size_t size)
{
    struct stat st;
    if (is_on_host(n, &path))
        return host_answer(n, (int)fence_readlink(n->sys->fence, path, buf, size));
    if (file_stat(n, path, &st) == 0)
        node_set_errno(EINVAL);
    return -1;
}

char *file_names(struct node *n, const char *path)
{
    if (is_on_host(n, &path)) {
        int flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
        return folder_names(host_answer(n, fence_open(n->sys->fence, path, flags, 0)));
    }
    bool masked = enter(n, "opendir");
    char *names = fs_of(n)->names(fs_of(n)->ctx, n, path);
    leave(n, masked);
    return names;
}

static int only_look(struct node *n, const char *path)
{
    struct stat st;
    return file_stat(n, path, &st);
}

int file_chmod(struct node *n, const char *path, mode_t permissions)
{
    if (!is_on_host(n, &path))
        return only_look(n, path);
    return host_answer(n, fence_chmod(n->sys->fence, path, permissions));
}

int file_utimes(struct node *n, const char *path, const struct timeval times[2])
{
    if (!is_on_host(n, &path))
        return only_look(n, path);
    return host_answer(n, fence_utimes(n->sys->fence, path, times));
}

int file_unlink(struct node *n, const char *path)
{
    if (is_on_host(n, &path))
        return host_answer(n, fence_unlink(n->sys->fence, path));
    bool masked = enter(n, "unlink");
    int r = fs_of(n)->unlink(fs_of(n)->ctx, n, path);
    leave(n, masked);
    return r;
}

int file_rename(struct node *n, const char *from, const char *to)
{
    from = folder_path(n, from, 0);
    to = folder_path(n, to, 1);
    if (file_is_simulated(from) != file_is_simulated(to)) {
        errno = EXDEV;
        return -1;
    }
    if (!file_is_simulated(from)) {
        node_order(n);
        note_host_file(n->sys, from);
        note_host_file(n->sys, to);
        return host_answer(n, fence_rename(n->sys->fence, from, to));
    }
    bool masked = enter(n, "rename");
    int r = fs_of(n)->rename(fs_of(n)->ctx, n, from, to);
    leave(n, masked);
    return r;
}

/* Only this computer has folders: in the machine's file system, names may contain / without any folder
 * being made. */
int file_make_folder(struct node *n, const char *path, mode_t permissions)
{
    if (!is_on_host(n, &path))
        return 0;
    return host_answer(n, fence_mkdir(n->sys->fence, path, permissions));
}

int file_remove_folder(struct node *n, const char *path)
{
    path = folder_path(n, path, 0);
    if (file_is_simulated(path))
        return 0;
    node_order(n);
    return host_answer(n, fence_rmdir(n->sys->fence, path));
}
