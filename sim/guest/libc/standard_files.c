/* standard_files.c - see standard_files.h. */
#include "guest/libc/standard_files.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>
#include "guest/libc/progress_line.h"
#include "node/node.h"
#include "node/system.h"

static int fd_of(const struct node_file *f)
{
    return ((const struct standard_file *)f)->fd;
}

static int fail(int why)
{
    errno = why;
    return -1;
}

/* --- input --- */

/* The host program and node 0 read one input in turn: neither may take more than a line, since the next may
 * be meant for the other. */
static ssize_t read_line(int fd, char *buf, size_t size)
{
    size_t done = 0;
    ssize_t n = 1;
    while (n == 1 && done < size && (done == 0 || buf[done - 1] != '\n'))
        if ((n = read(fd, buf + done, 1)) == 1)
            done++;
    return done > 0 ? (ssize_t)done : n;
}

static ssize_t in_read(struct node_file *f, void *buf, size_t bytes)
{
    fflush(f->node->sys->out[0]); /* the user may be asked for what is read here */
    return f->node->sys->cube ? read_line(fd_of(f), buf, bytes) : read(fd_of(f), buf, bytes);
}

static ssize_t in_write(struct node_file *f, const void *buf, size_t bytes)
{
    (void)f, (void)buf, (void)bytes;
    return fail(EBADF);
}

static int64_t in_seek(struct node_file *f, int64_t offset, int whence)
{
    return lseek64(fd_of(f), offset, whence);
}

static int in_close(struct node_file *f)
{
    if (fd_of(f) >= 0)
        close(fd_of(f));
    return 0;
}

/* --- output --- */

static ssize_t out_read(struct node_file *f, void *buf, size_t bytes)
{
    (void)f, (void)buf, (void)bytes;
    return fail(EBADF);
}

static ssize_t out_write(struct node_file *f, const void *bytes, size_t len)
{
    struct node_system *sys = f->node->sys;
    if (sys->progress && len)
        progress_line_make_way(sys->progress, bytes, len);
    if (fd_of(f) == STDERR_FILENO) {
        fflush(sys->out[0]); /* both may go to one file */
        if (len)
            sys->mid_line = ((const char *)bytes)[len - 1] != '\n';
    }
    return (ssize_t)fwrite(bytes, 1, len, sys->out[fd_of(f) - 1]);
}

static int64_t out_seek(struct node_file *f, int64_t offset, int whence)
{
    (void)f, (void)offset, (void)whence;
    return fail(ESPIPE);
}

static int out_close(struct node_file *f)
{
    (void)f;
    return 0;
}

/* --- both --- */

static int stat_terminal(struct node_file *f, struct stat *st)
{
    ino_t number = (ino_t)(f->class->read == in_read ? STDIN_FILENO : fd_of(f)) + 1;
    *st = (struct stat){.st_mode = S_IFCHR | 0620, .st_nlink = 1, .st_dev = (dev_t)-2, .st_ino = number};
    return 0;
}

static int truncate_terminal(struct node_file *f, int64_t size)
{
    (void)f, (void)size;
    return fail(EINVAL);
}

void standard_input(struct standard_file *f, struct node *n)
{
    static const struct node_file_class INPUT = {.terminal = true,
                                                 .read = in_read,
                                                 .write = in_write,
                                                 .seek = in_seek,
                                                 .stat = stat_terminal,
                                                 .truncate = truncate_terminal,
                                                 .close = in_close};
    *f = (struct standard_file){{.class = &INPUT, .node = n, .flags = O_RDONLY}, -1};
    if (n->id == 0 || n->is_host)
        f->fd = fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3);
}

void standard_output(struct standard_file *f, struct node *n, int fd)
{
    static const struct node_file_class OUTPUT = {.terminal = true,
                                                  .read = out_read,
                                                  .write = out_write,
                                                  .seek = out_seek,
                                                  .stat = stat_terminal,
                                                  .truncate = truncate_terminal,
                                                  .close = out_close};
    *f = (struct standard_file){{.class = &OUTPUT, .node = n, .flags = O_WRONLY}, fd};
}
