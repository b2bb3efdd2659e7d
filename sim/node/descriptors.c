/* descriptors.c - see descriptors.h; and the POSIX calls on descriptors and on names of files. Functions named
 * node_<name> serve the node program's <name>. */
#include "node/descriptors.h"
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "node/libc_parts.h"
#include "node/node.h"

int descriptor_new(struct node *n, struct node_file *f, const char *path)
{
    struct descriptors *d = &n->libc->descriptors;
    if (!f)
        return -1;
    for (int fd = 3; fd < NODE_DESCRIPTORS; fd++)
        if (!d->file[fd]) {
            d->file[fd] = f;
            d->path[fd] = strdup(path);
            return fd;
        }
    file_close(f);
    errno = EMFILE;
    return -1;
}

struct node_file *descriptor_file(struct node *n, int fd)
{
    struct node_file *f = fd >= 0 && fd < NODE_DESCRIPTORS ? n->libc->descriptors.file[fd] : NULL;
    if (!f)
        errno = EBADF;
    return f;
}

const char *descriptor_path(const struct node *n, int fd)
{
    const char *path = fd >= 0 && fd < NODE_DESCRIPTORS ? n->libc->descriptors.path[fd] : NULL;
    return path ? path : "?";
}

void descriptors_close(struct descriptors *d)
{
    for (int fd = 0; fd < NODE_DESCRIPTORS; fd++)
        if (d->file[fd]) {
            file_drop(d->file[fd]);
            free(d->path[fd]);
        }
}

/* The FILE of a standard descriptor that is not closed, else NULL. */
static FILE *standard(struct node *n, int fd)
{
    struct node_libc *c = n->libc;
    if (fd < 0 || fd > 2 || c->descriptors.closed[fd])
        return NULL;
    return fd == 0 ? c->streams.in : fd == 1 ? c->streams.out : c->streams.err;
}

/* --- POSIX. Lengths and offsets are the machine's: 32 bits, offsets with a sign. --- */

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
    free(n->libc->descriptors.path[fd]);
    n->libc->descriptors.file[fd] = NULL;
    n->libc->descriptors.path[fd] = NULL;
    return file_close(f);
}

/* From standard input: what stdio has not taken, no more than a line. */
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

int node_fstat(int fd, struct stat *st)
{
    struct node_file *f = descriptor_file(node_self(), fd);
    return f ? file_fstat(f, st) : -1;
}

/* --- names --- */

int node_stat(const char *path, struct stat *st)
{
    return file_stat(node_self(), path, st);
}

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
