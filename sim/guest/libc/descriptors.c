/* descriptors.c - a node's file descriptors (descriptors.h), and the POSIX calls on descriptors and on
 * names of files. A function node_NAME serves a node program's NAME. */
#include "guest/libc/descriptors.h"
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/uio.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "guest/libc/libc_parts.h"
#include "node/node.h"
#include "guest/libc/host_errno.h"
#include "node/self.h"

struct open_files *descriptors_open(struct node *n)
{
    struct descriptors *d = &libc_of(n)->descriptors;
    if (!d->open)
        d->open = xcalloc(1, sizeof *d->open);
    return d->open;
}

static struct standard_files *standard_of(struct node *n)
{
    struct descriptors *d = &libc_of(n)->descriptors;
    if (d->standard)
        return d->standard;
    struct standard_files *s = d->standard = xcalloc(1, sizeof *s);
    standard_input(&s->at_first[0], n);
    standard_output(&s->at_first[1], n, STDOUT_FILENO);
    standard_output(&s->at_first[2], n, STDERR_FILENO);
    for (int fd = 0; fd < 3; fd++)
        s->file[fd] = &s->at_first[fd].base;
    return s;
}

/* A descriptor's place, NULL: there is none, or the table has not been made. */
static struct node_file **place(struct node *n, int fd)
{
    struct open_files *open = libc_of(n)->descriptors.open;
    if (fd < 0 || fd >= NODE_DESCRIPTORS)
        return NULL;
    return fd < 3 ? &standard_of(n)->file[fd] : open ? &open->file[fd] : NULL;
}

/* Makes the table. */
static void set(struct node *n, int fd, struct node_file *f, const char *path)
{
    struct open_files *open = descriptors_open(n);
    free(open->path[fd]);
    open->path[fd] = path ? xstrdup(path) : NULL;
    *place(n, fd) = f;
}

/* The lowest free number from least on; -1 with errno EMFILE: there is none. */
static int lowest_free(struct node *n, int least)
{
    descriptors_open(n);
    for (int fd = least; fd < NODE_DESCRIPTORS; fd++)
        if (!*place(n, fd))
            return fd;
    errno = EMFILE;
    return -1;
}

int descriptor_reuse(struct node *n, int fd, struct node_file *f, const char *path)
{
    if (!f)
        return -1;
    descriptors_open(n);
    struct node_file **p = place(n, fd);
    if (!p || *p)
        fd = lowest_free(n, 0);
    if (fd >= 0) {
        set(n, fd, f, path);
    } else {
        file_close(f);
        node_set_errno(EMFILE);
    }
    return fd;
}

int descriptor_new(struct node *n, struct node_file *f, const char *path)
{
    return descriptor_reuse(n, -1, f, path);
}

struct node_file *descriptor_file(struct node *n, int fd)
{
    struct node_file **p = place(n, fd);
    if (p && *p)
        return *p;
    errno = EBADF;
    return NULL;
}

const char *descriptor_path(const struct node *n, int fd)
{
    const struct open_files *d = n->guest.libc ? n->guest.libc->descriptors.open : NULL;
    const char *path = d && fd >= 0 && fd < NODE_DESCRIPTORS ? d->path[fd] : NULL;
    return path ? path : "?";
}

int descriptor_close(struct node *n, int fd)
{
    struct node_file *f = descriptor_file(n, fd);
    if (!f)
        return -1;
    set(n, fd, NULL, NULL);
    return file_close(f);
}

static int copy(struct node *n, int fd, int to)
{
    struct node_file *f = descriptor_file(n, fd);
    if (!f || fd == to)
        return f ? fd : -1;
    if (to < 0 || to >= NODE_DESCRIPTORS) {
        errno = EBADF;
        return -1;
    }
    f->more++;
    if (*place(n, to))
        descriptor_close(n, to);
    set(n, to, f, descriptors_open(n)->path[fd]);
    return to;
}

int descriptor_copy_free(struct node *n, int fd, int least)
{
    if (!descriptor_file(n, fd))
        return -1;
    if (least < 0 || least >= NODE_DESCRIPTORS) {
        errno = EINVAL;
        return -1;
    }
    int to = lowest_free(n, least);
    return to < 0 ? -1 : copy(n, fd, to);
}

void descriptors_close(struct descriptors *d)
{
    for (int fd = 0; d->standard && fd < 3; fd++)
        if (d->standard->file[fd])
            file_drop(d->standard->file[fd]);
    for (int fd = 0; d->open && fd < NODE_DESCRIPTORS; fd++) {
        if (d->open->file[fd])
            file_drop(d->open->file[fd]);
        free(d->open->path[fd]);
    }
    free(d->open);
    free(d->standard);
}

/* The program's stream of a standard descriptor that is a terminal; NULL for any other. */
static FILE *terminal(struct node *n, int fd)
{
    const struct node_file *f = fd >= 0 && fd < 3 ? *place(n, fd) : NULL;
    return f && f->class->terminal ? stream_standard(n, fd) : NULL;
}

/* --- names of standard streams --- */

/* The descriptor that is the path's file; -1: the path is no such name. On this computer, these names lead to
 * what the run was started with: a pipe, a terminal, a file. A node has its own standard streams. */
static int named_descriptor(const char *path)
{
    static const char *const names[] = {"/dev/stdin", "/dev/stdout", "/dev/stderr",
                                        "/dev/fd/0",  "/dev/fd/1",   "/dev/fd/2"};
    for (int i = 0; i < 6; i++)
        if (strcmp(path, names[i]) == 0)
            return i % 3;
    return -1;
}

/* The open file of such a name, once more; NULL: the path is no such name, or the descriptor is closed. */
static struct node_file *named_file(struct node *n, const char *path)
{
    int fd = named_descriptor(path);
    struct node_file *f = fd < 0 ? NULL : descriptor_file(n, fd);
    if (f)
        f->more++;
    return f;
}

struct node_file *descriptor_open(struct node *n, const char *path, int flags, mode_t permissions)
{
    return named_descriptor(path) < 0 ? file_open(n, path, flags, permissions) : named_file(n, path);
}

static int stat_of(struct node *n, const char *path, struct stat *st)
{
    int fd = named_descriptor(path);
    struct node_file *f = fd < 0 ? NULL : descriptor_file(n, fd);
    return fd < 0 ? file_stat(n, path, st) : f ? file_fstat(f, st) : -1;
}

/* --- POSIX calls. As on the i860, a length is an unsigned number of 32 bits, an offset a signed one. --- */

int node_open(const char *path, int flags, ...)
{
    struct node *n = node_self();
    va_list ap;
    va_start(ap, flags);
    mode_t permissions = flags & O_CREAT ? va_arg(ap, mode_t) : 0;
    va_end(ap);
    return descriptor_new(n, descriptor_open(n, path, flags, permissions), path);
}

/* What GNU Fortran's library calls for OPEN. */
int node_nx_fortran_open(const char *path, int flags, mode_t permissions)
{
    struct node *n = node_self();
    struct node_file *named = named_file(n, path);
    return descriptor_new(n, named ? named : file_open_fortran(n, path, flags, permissions), path);
}

int node_creat(const char *path, mode_t permissions)
{
    return node_open(path, O_CREAT | O_WRONLY | O_TRUNC, permissions);
}

int node_close(int fd)
{
    return descriptor_close(node_self(), fd);
}

int node_dup(int fd)
{
    return descriptor_copy_free(node_self(), fd, 0);
}

int node_dup2(int fd, int to)
{
    return copy(node_self(), fd, to);
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
    if (fd == 0 && terminal(n, fd))
        return read_standard(terminal(n, fd), buf, (uint32_t)bytes);
    struct node_file *f = descriptor_file(n, fd);
    return f ? file_read(f, buf, (uint32_t)bytes) : -1;
}

ssize_t node_write(int fd, const void *buf, size_t bytes)
{
    struct node *n = node_self();
    if (fd > 0 && terminal(n, fd)) {
        FILE *out = terminal(n, fd);
        return fwrite(buf, 1, (uint32_t)bytes, out) == (uint32_t)bytes && fflush(out) == 0 ? (ssize_t)bytes
                                                                                           : -1;
    }
    struct node_file *f = descriptor_file(n, fd);
    return f ? file_write(f, buf, (uint32_t)bytes) : -1;
}

/* A terminal has no place, also where the simulator's input has one. */
long long node_nx_lseek(int fd, long long offset, int whence)
{
    struct node_file *f = descriptor_file(node_self(), fd);
    if (f && f->class->terminal) {
        errno = ESPIPE;
        return -1;
    }
    return f ? file_seek(f, offset, whence) : -1;
}

/* Programs call it without a declaration: what is not of an int is not the offset's. */
off_t node_lseek(int fd, off_t offset, int whence)
{
    return node_nx_lseek(fd, (int32_t)offset, whence);
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

int node_isatty(int fd)
{
    const struct node_file *f = descriptor_file(node_self(), fd);
    if (f && !f->class->terminal)
        errno = ENOTTY;
    return f && f->class->terminal;
}

int node_ttyname_r(int fd, char *buf, size_t size)
{
    (void)buf, (void)size;
    return node_isatty(fd) ? ENODEV : errno; /* the terminal has no name */
}

int node_fstat(int fd, struct stat *st)
{
    struct node_file *f = descriptor_file(node_self(), fd);
    return f ? file_fstat(f, st) : -1;
}

int node_nx_ftruncate(int fd, long long size)
{
    struct node_file *f = descriptor_file(node_self(), fd);
    return f ? file_truncate(f, size) : -1;
}

int node_ftruncate(int fd, off_t size)
{
    return node_nx_ftruncate(fd, (int32_t)size);
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
    return stat_of(node_self(), path, st);
}

int node_lstat(const char *path, struct stat *st)
{
    return file_lstat(node_self(), path, st);
}

int node_chmod(const char *path, mode_t permissions)
{
    return file_chmod(node_self(), path, permissions);
}

int node_utimes(const char *path, const struct timeval times[2])
{
    return file_utimes(node_self(), path, times);
}

ssize_t node_readlink(const char *path, char *buf, size_t size)
{
    return file_readlink(node_self(), path, buf, size);
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
    return descriptor_file(node_self(), fd) ? 0 : -1;
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
    return stat_of(node_self(), path, &st);
}
