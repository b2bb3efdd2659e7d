/* streams.c - see streams.h. */
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "guest/file.h"
#include "guest/progress_line.h"
#include "node/node.h"
#include "guest/streams.h"
#include "node/system.h"
#include "guest/host_errno.h"
#include "node/self.h"
#include "os/gate.h"

/* --- what a FILE calls --- */

/* Does the stream's own node close or flush it? Otherwise the host does, at the end of the node or of the
 * simulator. */
static bool on_its_node(const struct stream *s)
{
    return node_is_self(s->node);
}

/* The host program and node 0 read one input in turn: neither may take more than a line, since the next may
 * be meant for the other. */
static ssize_t read_line(struct node_file *f, char *buf, size_t size)
{
    size_t done = 0;
    ssize_t n = 1;
    while (n == 1 && done < size && (done == 0 || buf[done - 1] != '\n'))
        if ((n = file_read(f, buf + done, 1)) == 1)
            done++;
    return done > 0 ? (ssize_t)done : n;
}

static ssize_t stream_read(void *cookie, char *buf, size_t size)
{
    struct stream *s = cookie;
    if (s->kind != STREAM_FILE) {
        errno = EBADF;
        return -1;
    }
    return s->by_lines ? read_line(s->target, buf, size) : file_read(s->target, buf, size);
}

/* Passes on bytes that the program wrote to its output (fd 1) or error output (fd 2). */
static void write_out(struct node *n, int fd, const char *bytes, size_t len)
{
    FILE *const *out = n->sys->out;
    if (n->sys->progress && len)
        progress_line_make_way(n->sys->progress, bytes, len);
    if (fd == 2)
        fflush(out[0]); /* both may go to one file */
    fwrite(bytes, 1, len, out[fd - 1]);
}

static ssize_t stream_write(void *cookie, const char *buf, size_t size)
{
    struct stream *s = cookie;
    if (!on_its_node(s))
        return (ssize_t)size;
    if (s->kind == STREAM_CLOSED) {
        errno = EBADF;
        return 0;
    }
    if (s->kind == STREAM_FILE) {
        ssize_t done = file_write(s->target, buf, size);
        return done < 0 ? 0 : done;
    }
    node_order(s->node);
    write_out(s->node, s->fd, buf, size);
    return (ssize_t)size;
}

static int stream_seek(void *cookie, off64_t *offset, int whence)
{
    struct stream *s = cookie;
    if (s->kind != STREAM_FILE) {
        errno = ESPIPE;
        return -1;
    }
    if (!on_its_node(s))
        return -1; /* the host's C library closes its streams at the end */
    off64_t at = file_seek(s->target, *offset, whence);
    if (at < 0)
        return -1;
    *offset = at;
    return 0;
}

static int close_target(struct stream *s)
{
    int r = 0;
    if (s->kind == STREAM_FILE && on_its_node(s))
        r = file_close(s->target);
    else if (s->kind == STREAM_FILE)
        file_drop(s->target);
    s->kind = STREAM_CLOSED;
    s->target = NULL;
    return r;
}

static int stream_close(void *cookie)
{
    return close_target(cookie);
}

/* --- the list --- */

/* target is NULL unless kind is STREAM_FILE. */
static struct stream *add_stream(struct streams *list, struct node *n, enum stream_kind kind,
                                 struct node_file *target, const char *mode)
{
    static const cookie_io_functions_t functions = {stream_read, stream_write, stream_seek, stream_close};
    struct stream *s = xcalloc(1, sizeof *s);
    s->file = xchecked(fopencookie(s, mode, functions));
    __fsetlocking(s->file, FSETLOCKING_BYCALLER);
    s->node = n;
    s->kind = kind;
    s->target = target;
    s->next = list->all;
    list->all = s;
    return s;
}

static struct stream *find_stream(const struct streams *list, const FILE *f)
{
    struct stream *s = list->all;
    while (s != NULL && s->file != f)
        s = s->next;
    return s;
}

static void remove_stream(struct streams *list, struct stream *s)
{
    struct stream **link = &list->all;
    while (*link != s)
        link = &(*link)->next;
    *link = s->next;
    free(s);
}

static struct stream *add_standard(struct streams *list, struct node *n, enum stream_kind kind,
                                   struct node_file *target, const char *mode)
{
    struct stream *s = add_stream(list, n, kind, target, mode);
    s->standard = true;
    return s;
}

static FILE *add_output(struct streams *list, struct node *n, int fd)
{
    struct stream *s = add_standard(list, n, STREAM_OUTPUT, NULL, "w");
    s->fd = fd;
    return s->file;
}

/* The simulator's standard input is node 0's, and the host program's if there is one. */
void streams_open(struct streams *list, struct node *n)
{
    int fd = n->id == 0 || n->is_host ? fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3) : -1;
    struct node_file *in = file_of_host(n, fd);
    struct stream *input = add_standard(list, n, in ? STREAM_FILE : STREAM_CLOSED, in, "r");
    input->by_lines = n->sys->cube != NULL;
    list->in = input->file;
    list->out = add_output(list, n, STDOUT_FILENO);
    list->err = add_output(list, n, STDERR_FILENO);
    setvbuf(list->out, NULL, _IOLBF, BUFSIZ);
    setvbuf(list->err, NULL, _IONBF, 0);
}

void streams_flush(struct streams *list)
{
    for (struct stream *s = list->all; s != NULL; s = s->next)
        if (__fwriting(s->file))
            fflush(s->file);
}

static void rescue(const struct stream *s)
{
    const char *bytes = s->file->_IO_write_base; /* glibc's: there is no function for it */
    size_t held = __fwriting(s->file) ? __fpending(s->file) : 0;
    if (held == 0 || held > __fbufsize(s->file))
        return;
    if (s->kind == STREAM_OUTPUT)
        write_out(s->node, s->fd, bytes, held);
    else if (s->kind == STREAM_FILE && !s->target->class->simulated)
        s->target->class->write(s->target, bytes, held);
    __fpurge(s->file);
}

void streams_rescue(struct streams *list)
{
    for (struct stream *s = list->all; s != NULL; s = s->next)
        rescue(s);
}

void streams_close(struct streams *list)
{
    while (list->all != NULL) {
        struct stream *s = list->all;
        __fpurge(s->file);
        fclose(s->file);
        remove_stream(list, s);
    }
}

/* --- files --- */

/* Flags of open() for a mode of fopen(); -1 with errno EINVAL if the mode is none. */
static int open_flags(const char *mode)
{
    int flags = *mode == 'r' ? 0 : *mode == 'w' ? O_CREAT | O_TRUNC : *mode == 'a' ? O_CREAT | O_APPEND : -1;
    if (flags < 0) {
        errno = EINVAL;
        return -1;
    }
    if (strchr(mode, 'x') != NULL)
        flags |= O_EXCL;
    if (strchr(mode, '+') != NULL)
        return flags | O_RDWR | O_CLOEXEC;
    return flags | (*mode == 'r' ? O_RDONLY : O_WRONLY) | O_CLOEXEC;
}

static struct node_file *open_file(struct node *n, const char *path, const char *mode)
{
    int flags = open_flags(mode);
    struct node_file *f = flags < 0 ? NULL : file_open(n, path, flags, 0666);
    if (f != NULL && *mode == 'a')
        file_seek(f, 0, SEEK_END);
    return f;
}

static FILE *file_of(struct streams *list, struct node *n, struct node_file *f, const char *mode)
{
    return f == NULL ? NULL : add_stream(list, n, STREAM_FILE, f, mode)->file;
}

FILE *stream_fopen(struct streams *list, struct node *n, const char *path, const char *mode)
{
    return file_of(list, n, open_file(n, path, mode), mode);
}

FILE *stream_tmpfile(struct streams *list, struct node *n)
{
    char path[] = P_tmpdir "/nodeXXXXXX";
    int fd = mkostemp(path, O_CLOEXEC);
    if (fd >= 0)
        unlink(path);
    return file_of(list, n, file_of_host(n, fd), "w+");
}

int stream_fclose(struct streams *list, FILE *f)
{
    struct stream *s = find_stream(list, f);
    if (s == NULL) {
        errno = EBADF;
        return EOF;
    }
    int r = __fwriting(f) ? fflush(f) : 0;
    node_order(s->node);
    if (s->standard)
        return close_target(s) | r;
    r |= fclose(f);
    remove_stream(list, s);
    return r;
}

/* The FILE stays and gets another target, so the program goes on reading and writing through its node. The
 * FILE can then be used only in the directions that it was made for. That is what programs do: stdin to
 * "r", stdout and stderr to "w". */
FILE *stream_freopen(struct streams *list, const char *path, const char *mode, FILE *f)
{
    struct stream *s = find_stream(list, f);
    bool reads = *mode == 'r' || strchr(mode, '+') != NULL,
         writes = *mode != 'r' || strchr(mode, '+') != NULL;
    if (s == NULL || path == NULL || (reads && !__freadable(f)) || (writes && !__fwritable(f))) {
        errno = EINVAL;
        return NULL;
    }
    if (__fwriting(f))
        fflush(f);
    close_target(s);
    struct node_file *target = open_file(s->node, path, mode);
    if (target == NULL) {
        int why = node_errno();
        if (!s->standard)
            stream_fclose(list, f);
        node_set_errno(why);
        return NULL;
    }
    s->target = target;
    s->kind = STREAM_FILE;
    s->by_lines = false;
    __fpurge(f);
    fseek(f, 0, *mode == 'a' ? SEEK_END : SEEK_SET); /* forget the position in the old file */
    clearerr(f);
    setvbuf(f, NULL, _IOFBF, BUFSIZ);
    return f;
}
