/* streams.c - see streams.h. */
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "guest/libc/libc_parts.h"
#include "guest/libc/memory_file.h"
#include "node/node.h"
#include "guest/libc/streams.h"
#include "guest/libc/host_errno.h"
#include "node/self.h"
#include "node/system.h"
#include "os/gate.h"

/* --- what a FILE calls --- */

/* Does the stream's own node close or flush it? Otherwise the host does, at the end of the node or of the
 * simulator. */
static bool on_its_node(const struct stream *s)
{
    return node_is_self(s->node);
}

static struct node_file *file_under(const struct stream *s)
{
    return s->memory ? s->memory : descriptor_file(s->node, s->fd);
}

/* Shows what the user may be asked by, also if its line has no end, as the C library does that reads from a
 * terminal. */
static void show_question(struct node *n)
{
    FILE *out = streams_of(n)->standard[STDOUT_FILENO];
    int before = node_errno();
    const struct node_file *to = out ? descriptor_file(n, STDOUT_FILENO) : NULL;
    if (to && to->class->terminal && isatty(STDIN_FILENO))
        fflush(out);
    node_set_errno(before);
}

static ssize_t stream_read(void *cookie, char *buf, size_t size)
{
    struct stream *s = cookie;
    struct node_file *f = file_under(s);
    if (f && f->class->terminal)
        show_question(s->node);
    return f ? file_read(f, buf, size) : -1;
}

static ssize_t stream_write(void *cookie, const char *buf, size_t size)
{
    struct stream *s = cookie;
    if (!on_its_node(s))
        return (ssize_t)size;
    struct node_file *f = file_under(s);
    ssize_t done = f ? file_write(f, buf, size) : 0;
    return done < 0 ? 0 : done;
}

static int stream_seek(void *cookie, off64_t *offset, int whence)
{
    struct stream *s = cookie;
    if (!on_its_node(s))
        return -1; /* the host's C library closes its streams at the end */
    struct node_file *f = file_under(s);
    off64_t at = f ? file_seek(f, *offset, whence) : -1;
    if (at < 0)
        return -1;
    *offset = at;
    return 0;
}

/* --- the list --- */

static struct stream *add_at(struct stream **link, struct node *n, int fd, const char *mode)
{
    static const cookie_io_functions_t functions = {stream_read, stream_write, stream_seek, NULL};
    struct stream *s = xcalloc(1, sizeof *s);
    s->file = xchecked(fopencookie(s, mode, functions));
    __fsetlocking(s->file, FSETLOCKING_BYCALLER);
    s->node = n;
    s->fd = fd;
    s->made = ++n->sys->streams_made;
    s->next = *link;
    return *link = s;
}

static struct stream *add_stream(struct streams *list, struct node *n, int fd, const char *mode)
{
    return add_at(&list->all, n, fd, mode);
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
    if (s->memory)
        file_drop(s->memory);
    free(s);
}

/* Where a standard stream belongs in the list: before those of lower descriptors. */
static struct stream **place_of(struct streams *list, int fd)
{
    struct stream **link = &list->all;
    for (; *link; link = &(*link)->next)
        for (int below = 0; below < fd; below++)
            if ((*link)->file == list->standard[below])
                return link;
    return link;
}

static FILE *new_standard(struct node *n, int fd)
{
    struct streams *list = streams_of(n);
    struct stream *s = add_at(place_of(list, fd), n, fd, fd == STDIN_FILENO ? "r" : "w");
    s->standard = true;
    if (fd != STDIN_FILENO)
        setvbuf(s->file, NULL, fd == STDOUT_FILENO ? _IOLBF : _IONBF, fd == STDOUT_FILENO ? BUFSIZ : 0);
    return s->file;
}

FILE **stream_variable(struct node *n, int fd)
{
    FILE **f = &streams_of(n)->standard[fd];
    if (!*f)
        *f = new_standard(n, fd);
    return f;
}

FILE *stream_standard(struct node *n, int fd)
{
    return *stream_variable(n, fd);
}

struct streams *streams_of(struct node *n)
{
    return &libc_of(n)->streams;
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
    struct node_file *f = descriptor_file(s->node, s->fd);
    if (f && !f->class->simulated)
        f->class->write(f, bytes, held);
    __fpurge(s->file);
}

void streams_rescue(struct streams *list)
{
    for (struct stream *s = list->all; s != NULL; s = s->next)
        rescue(s);
}

static void close_stream(const struct stream *s)
{
    __fpurge(s->file);
    fclose(s->file);
}

void streams_close(struct streams *list)
{
    while (list->all != NULL) {
        close_stream(list->all);
        remove_stream(list, list->all);
    }
}

static int latest_first(const void *a, const void *b)
{
    uint64_t x = (*(struct stream *const *)a)->made, y = (*(struct stream *const *)b)->made;
    return (x < y) - (x > y);
}

/* Puts all streams of the nodes into a list, NULL: only counts them. */
static size_t collect(struct node *const *nodes, uint32_t count, struct stream **to)
{
    size_t found = 0;
    for (uint32_t i = 0; i < count; i++)
        for (struct stream *s = nodes[i] && nodes[i]->guest.libc ? streams_of(nodes[i])->all : NULL; s;
             s = s->next)
            if (found++, to)
                to[found - 1] = s;
    return found;
}

void streams_close_all(struct node *const *nodes, uint32_t count)
{
    size_t found = collect(nodes, count, NULL);
    struct stream **all = xcalloc(found, sizeof(struct stream *));
    collect(nodes, count, all);
    qsort(all, found, sizeof *all, latest_first);
    for (size_t i = 0; i < found; i++) {
        close_stream(all[i]);
        remove_stream(streams_of(all[i]->node), all[i]);
    }
    free(all);
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
    struct node_file *f = flags < 0 ? NULL : descriptor_open(n, path, flags, 0666);
    if (f != NULL && *mode == 'a')
        file_seek(f, 0, SEEK_END);
    return f;
}

/* A stream of an open file, which gets a descriptor. */
static FILE *file_of(struct streams *list, struct node *n, struct node_file *f, const char *path,
                     const char *mode)
{
    int fd = descriptor_new(n, f, path);
    return fd < 0 ? NULL : add_stream(list, n, fd, mode)->file;
}

FILE *stream_fopen(struct streams *list, struct node *n, const char *path, const char *mode)
{
    return file_of(list, n, open_file(n, path, mode), path, mode);
}

FILE *stream_tmpfile(struct streams *list, struct node *n)
{
    char path[] = P_tmpdir "/nodeXXXXXX";
    int fd = mkostemp(path, O_CLOEXEC);
    if (fd >= 0)
        unlink(path);
    return file_of(list, n, file_of_host(n, fd, O_RDWR), path, "w+");
}

FILE *stream_fdopen(struct streams *list, struct node *n, int fd, const char *mode)
{
    struct node_file *f = descriptor_file(n, fd);
    if (f == NULL || open_flags(mode) < 0)
        return NULL;
    if (*mode == 'a')
        file_seek(f, 0, SEEK_END);
    return add_stream(list, n, fd, mode)->file;
}

static FILE *stream_of_memory(struct streams *list, struct node *n, struct node_file *f, const char *mode)
{
    if (!f)
        return NULL;
    struct stream *s = add_stream(list, n, -1, mode);
    s->memory = f;
    return s->file;
}

FILE *stream_open_memstream(struct streams *list, struct node *n, char **text, size_t *size)
{
    return stream_of_memory(list, n, memory_file_growing(n, text, size), "w");
}

FILE *stream_fmemopen(struct streams *list, struct node *n, void *at, size_t size, const char *mode)
{
    if (open_flags(mode) < 0)
        return NULL;
    return stream_of_memory(list, n, memory_file_fixed(n, at, size, mode), mode);
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
    if (!s->memory)
        r |= descriptor_close(s->node, s->fd);
    if (s->standard) {
        s->fd = -1;
        return r;
    }
    r |= fclose(f);
    remove_stream(list, s);
    return r;
}

int stream_fileno(const struct streams *list, const FILE *f)
{
    const struct stream *s = find_stream(list, f);
    if (s != NULL && s->fd >= 0)
        return s->fd;
    errno = EBADF;
    return -1;
}

/* The FILE stays and its descriptor gets another file, so the program goes on reading and writing through its
 * node. The FILE can then be used only in the directions that it was made for. That is what programs do:
 * stdin to "r", stdout and stderr to "w". */
FILE *stream_freopen(struct streams *list, const char *path, const char *mode, FILE *f)
{
    struct stream *s = find_stream(list, f);
    bool reads = *mode == 'r' || strchr(mode, '+') != NULL,
         writes = *mode != 'r' || strchr(mode, '+') != NULL;
    if (s == NULL || s->memory || path == NULL || (reads && !__freadable(f)) || (writes && !__fwritable(f))) {
        errno = EINVAL;
        return NULL;
    }
    if (__fwriting(f))
        fflush(f);
    descriptor_close(s->node, s->fd);
    s->fd = descriptor_reuse(s->node, s->fd, open_file(s->node, path, mode), path);
    if (s->fd < 0) {
        int why = node_errno();
        if (!s->standard)
            stream_fclose(list, f);
        node_set_errno(why);
        return NULL;
    }
    __fpurge(f);
    fseek(f, 0, *mode == 'a' ? SEEK_END : SEEK_SET); /* forget the position in the old file */
    clearerr(f);
    setvbuf(f, NULL, _IOFBF, BUFSIZ);
    return f;
}
