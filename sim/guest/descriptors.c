/* descriptors.c - a node's file descriptors (descriptors.h), and the POSIX calls on descriptors and on
 * names of files. A function node_NAME serves a node program's NAME. */
#include "guest/descriptors.h"
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/uio.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "guest/libc_parts.h"
#include "node/node.h"
#include "node/self.h"

struct open_files *descriptors_open(struct node *n)
{
    struct descriptors *d = &n->libc->descriptors;
    if (!d->open)
        d->open = xcalloc(1, sizeof *d->open);
    return d->open;
}

int descriptor_new(struct node *n, struct node_file *f, const char *path)
{
    if (!f)
        return -1;
    struct open_files *d = descriptors_open(n);
    for (int fd = 3; fd < NODE_DESCRIPTORS; fd++)
        if (!d->file[fd]) {
            d->file[fd] = f;
            d->path[fd] = xstrdup(path);
            return fd;
        }
    file_close(f);
    errno = EMFILE;
    return -1;
}

struct node_file *descriptor_file(struct node *n, int fd)
{
    const struct open_files *d = n->libc->descriptors.open;
    struct node_file *f = d && fd >= 0 && fd < NODE_DESCRIPTORS ? d->file[fd] : NULL;
    if (!f)
        errno = EBADF;
    return f;
}

const char *descriptor_path(const struct node *n, int fd)
{
    const struct open_files *d = n->libc->descriptors.open;
    const char *path = d && fd >= 0 && fd < NODE_DESCRIPTORS ? d->path[fd] : NULL;
    return path ? path : "?";
}

void descriptors_close(struct descriptors *d)
{
    for (int fd = 0; d->open && fd < NODE_DESCRIPTORS; fd++)
        if (d->open->file[fd]) {
            file_drop(d->open->file[fd]);
            free(d->open->path[fd]);
        }
    free(d->open);
}

/* The stream of a standard descriptor; NULL for any other, and for one that the program has closed. */
static FILE *standard(struct node *n, int fd)
{
    struct node_libc *c = n->libc;
    if (fd < 0 || fd > 2 || c->descriptors.closed[fd])
        return NULL;
    return fd == 0 ? c->streams.in : fd == 1 ? c->streams.out : c->streams.err;
}

/* --- POSIX calls. As on the i860, a length is an unsigned number of 32 bits, an offset a signed one. --- */

int node_open(const char *path, int flags, ...)
{
    struct node *n = node_self();
    va_list ap;
    va_start(ap, flags);
    mode_t permissions = flags & O_CREAT ? va_arg(ap, mode_t) : 0;
    va_end(ap);
    return descriptor_new(n, file_open(n, path, flags, permissions), path);
}

int node_creat(const char *path, mode_t permissions)
{
    return node_open(path, O_CREAT | O_WRONLY | O_TRUNC, permissions);
}

int node_close(int fd)
{
    struct node *n = node_self();
    if (standard(n, fd)) {
        n->libc->descriptors.closed[fd] = true;
        return 0;
    }
    struct node_file *f = descriptor_file(n, fd);
    if (!f)
        return -1;
    struct open_files *d = n->libc->descriptors.open;
    free(d->path[fd]);
    d->file[fd] = NULL;
    d->path[fd] = NULL;
    return file_close(f);
}

/* Reads from standard input what stdio has not taken, at most one line. */
static ssize_t read_standard(FILE *in, char *buf, size_t bytes)
{
    size_t done = 0;
    int c = 0;
    while (done < bytes && c != '\n' && (c = getc(in)) != EOF)
        buf[done++] = (char)c;
    return done == 0 && ferror(in) ? -1 : (ssize_t)done;
}

ssize_t node_read(int fd, void *buf, size_t bytes)
{
    struct node *n = node_self();
    if (fd == 0 && standard(n, fd))
        return read_standard(standard(n, fd), buf, (uint32_t)bytes);
    struct node_file *f = descriptor_file(n, fd);
    return f ? file_read(f, buf, (uint32_t)bytes) : -1;
}

ssize_t node_write(int fd, const void *buf, size_t bytes)
{
    struct node *n = node_self();
    if (fd > 0 && standard(n, fd)) {
        FILE *out = standard(n, fd);
        return fwrite(buf, 1, (uint32_t)bytes, out) == (uint32_t)bytes && fflush(out) == 0 ? (ssize_t)bytes
                                                                                           : -1;
    }
    struct node_file *f = descriptor_file(n, fd);
    return f ? file_write(f, buf, (uint32_t)bytes) : -1;
}

off_t node_lseek(int fd, off_t offset, int whence)
{
    struct node_file *f = descriptor_file(node_self(), fd);
    return f ? file_seek(f, (int32_t)offset, whence) : -1;
}

ssize_t node_writev(int fd, const struct iovec *parts, int count)
{
    ssize_t done = 0;
    for (int i = 0; i < count; i++) {
        ssize_t n = node_write(fd, parts[i].iov_base, parts[i].iov_len);
        if (n < 0)
            return done > 0 ? done : -1;
        done += n;
        if ((size_t)n < parts[i].iov_len)
            break;
    }
    return done;
}

/* A standard descriptor is a terminal, whatever the simulator's own is: what a program prints, and when,
 * must not depend on how the simulator is run. */
int node_isatty(int fd)
{
    if (standard(node_self(), fd))
        return 1;
    errno = descriptor_file(node_self(), fd) ? ENOTTY : EBADF;
    return 0;
}

int node_ttyname_r(int fd, char *buf, size_t size)
{
    (void)buf, (void)size;
    return node_isatty(fd) ? ENODEV : errno; /* the terminal has no name */
}

int node_fstat(int fd, struct stat *st)
{
    struct node *n = node_self();
    if (standard(n, fd)) {
        *st = (struct stat){
            .st_mode = S_IFCHR | 0620, .st_nlink = 1, .st_dev = (dev_t)-2, .st_ino = (ino_t)fd + 1};
        return 0;
    }
    struct node_file *f = descriptor_file(n, fd);
    return f ? file_fstat(f, st) : -1;
}

int node_ftruncate(int fd, off_t size)
{
    struct node_file *f = descriptor_file(node_self(), fd);
    return f ? file_truncate(f, (int32_t)size) : -1;
}

/* Opens a new file with O_EXCL. The names tried differ from node to node and are equal in each run; names
 * of existing files are skipped. */
int node_mkostemp(char *pattern, int flags)
{
    size_t len = strlen(pattern);
    if (len < 6 || strcmp(pattern + len - 6, "XXXXXX") != 0) {
        errno = EINVAL;
        return -1;
    }
    for (unsigned i = 0; i < 1000; i++) {
        char digits[24];
        snprintf(digits, sizeof digits, "%03u%03u", node_self()->id % 1000, i);
        memcpy(pattern + len - 6, digits, 6);
        int fd = descriptor_new(node_self(), file_open_temporary(node_self(), pattern, flags), pattern);
        if (fd >= 0 || errno != EEXIST)
            return fd;
    }
    errno = EEXIST;
    return -1;
}

int node_mkstemp(char *pattern)
{
    return node_mkostemp(pattern, 0);
}

/* Returns the first name that no file has. */
char *node_mktemp(char *pattern)
{
    int fd = node_mkostemp(pattern, 0);
    if (fd < 0) {
        *pattern = 0;
        return pattern;
    }
    node_close(fd);
    file_unlink(node_self(), pattern);
    return pattern;
}

/* A file's permissions are those that the program asks for, less the umask of the simulator's user. */
mode_t node_umask(mode_t mask)
{
    (void)mask;
    return 0;
}

/* --- names --- */

int node_stat(const char *path, struct stat *st)
{
    return file_stat(node_self(), path, st);
}

int node_lstat(const char *path, struct stat *st)
{
    return file_lstat(node_self(), path, st);
}

int node_mkdir(const char *path, mode_t permissions)
{
    return file_make_folder(node_self(), path, permissions);
}

int node_rmdir(const char *path)
{
    return file_remove_folder(node_self(), path);
}

/* Nothing is to be done: a written byte is in its file at once. */
int node_fsync(int fd)
{
    return standard(node_self(), fd) || descriptor_file(node_self(), fd) ? 0 : -1;
}

void node_sync(void) {}

int node_unlink(const char *path)
{
    return file_unlink(node_self(), path);
}

int node_rename(const char *from, const char *to)
{
    return file_rename(node_self(), from, to);
}

int node_access(const char *path, int how)
{
    struct stat st;
    (void)how; /* whoever may see a file may use it */
    return file_stat(node_self(), path, &st);
}
