/* memory_file.c - see memory_file.h. */
#include "guest/libc/memory_file.h"
#include <errno.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "guest/libc/file.h"
#include "guest/libc/host_errno.h"
#include "node/self.h"

void *node_malloc(size_t bytes);
void *node_realloc(void *p, size_t bytes);
void node_free(void *p);

struct memory_file {
    struct node_file base;
    char *bytes;
    size_t length, room, place; /* room: with the 0 at the end, if it grows */
    bool appends, owns;         /* owns: frees the bytes when it is closed */
    char **text;                /* the program's variables; NULL: it does not grow */
    size_t *size;
};

static struct memory_file *of(struct node_file *f)
{
    return (struct memory_file *)f;
}

static ssize_t read_memory(struct node_file *base, void *buf, size_t bytes)
{
    struct memory_file *f = of(base);
    size_t left = f->place < f->length ? f->length - f->place : 0, n = bytes < left ? bytes : left;
    memcpy(buf, f->bytes + f->place, n);
    f->place += n;
    return (ssize_t)n;
}

static void tell(const struct memory_file *f)
{
    *f->text = f->bytes;
    *f->size = f->place < f->length ? f->place : f->length;
}

/* Room for so many bytes and a 0 behind them. */
static bool grow(struct memory_file *f, size_t bytes)
{
    if (bytes < f->room)
        return true;
    size_t room = 2 * f->room > bytes + 1 ? 2 * f->room : bytes + 1;
    char *larger = node_realloc(f->bytes, room);
    if (!larger)
        return false;
    memset(larger + f->room, 0, room - f->room);
    f->bytes = larger;
    f->room = room;
    return true;
}

static ssize_t write_growing(struct memory_file *f, const void *buf, size_t bytes)
{
    if (!grow(f, f->place + bytes)) {
        node_set_errno(ENOMEM);
        return -1;
    }
    memcpy(f->bytes + f->place, buf, bytes);
    f->place += bytes;
    if (f->place > f->length)
        f->length = f->place;
    f->bytes[f->length] = 0;
    tell(f);
    return (ssize_t)bytes;
}

/* A 0 follows what has been written, where there is room. */
static ssize_t write_fixed(struct memory_file *f, const void *buf, size_t bytes)
{
    if (f->appends)
        f->place = f->length;
    size_t left = f->place < f->room ? f->room - f->place : 0, n = bytes < left ? bytes : left;
    if (n == 0 && bytes > 0) {
        errno = ENOSPC;
        return -1;
    }
    memcpy(f->bytes + f->place, buf, n);
    f->place += n;
    if (f->place > f->length) {
        f->length = f->place;
        if (f->length < f->room)
            f->bytes[f->length] = 0;
    }
    return (ssize_t)n;
}

static ssize_t write_memory(struct node_file *f, const void *buf, size_t bytes)
{
    return of(f)->text ? write_growing(of(f), buf, bytes) : write_fixed(of(f), buf, bytes);
}

static int64_t seek_memory(struct node_file *base, int64_t offset, int whence)
{
    struct memory_file *f = of(base);
    int64_t at = offset + (whence == SEEK_SET ? 0 : (int64_t)(whence == SEEK_CUR ? f->place : f->length));
    if (at < 0 || (!f->text && at > (int64_t)f->room)) {
        errno = EINVAL;
        return -1;
    }
    f->place = (size_t)at;
    if (f->text)
        tell(f);
    return at;
}

static int close_memory(struct node_file *base)
{
    struct memory_file *f = of(base);
    if (f->owns && node_is_self(base->node))
        node_free(f->bytes);
    free(f);
    return 0;
}

static struct node_file *new_file(struct node *n, const struct memory_file *is)
{
    static const struct node_file_class MEMORY = {
        .read = read_memory, .write = write_memory, .seek = seek_memory, .close = close_memory};
    struct memory_file *f = xmalloc(sizeof *f);
    *f = *is;
    f->base = (struct node_file){.class = &MEMORY, .node = n};
    return &f->base;
}

struct node_file *memory_file_growing(struct node *n, char **text, size_t *size)
{
    enum { AT_FIRST = 128 };
    char *bytes = node_malloc(AT_FIRST);
    if (!bytes)
        return NULL;
    memset(bytes, 0, AT_FIRST);
    struct node_file *f =
        new_file(n, &(struct memory_file){.bytes = bytes, .room = AT_FIRST, .text = text, .size = size});
    tell(of(f));
    return f;
}

struct node_file *memory_file_fixed(struct node *n, void *at, size_t size, const char *mode)
{
    struct memory_file f = {.bytes = at, .room = size, .owns = at == NULL, .appends = *mode == 'a'};
    if (f.owns) {
        f.bytes = node_malloc(size);
        if (!f.bytes)
            return NULL;
        memset(f.bytes, 0, size);
    }
    if (*mode == 'w' && size > 0)
        *f.bytes = 0;
    f.length = *mode == 'r' ? size : *mode == 'a' ? strnlen(f.bytes, size) : 0;
    f.place = f.appends ? f.length : 0;
    return new_file(n, &f);
}
