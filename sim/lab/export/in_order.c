/* in_order.c - see in_order.h. In the temporary file streams follow each other; a line is its head and its
 * bytes. Writing merges the streams by a heap of their next lines. */
#include "lab/export/in_order.h"
#include <assert.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"

enum { MOST_BYTES = 4000, BUFFER = 8192 };

struct head {
    vtime time;
    uint32_t bytes;
};

struct stream {
    off_t at, end;   /* in the file: what is not in the buffer yet */
    vtime last;      /* while lines are added */
    char *buffer;    /* of BUFFER bytes */
    size_t from, to; /* what is unread of the buffer; begins with a head */
};

struct in_order {
    FILE *file;
    struct stream *streams;
    size_t count, room;
    size_t *heap, heaped; /* streams that have a line, the earliest first */
};

static char *fault(void)
{
    return xasprintf("a temporary file cannot be used: %s", strerror(errno ? errno : EIO));
}

struct in_order *in_order_new(char **error)
{
    FILE *file = tmpfile();
    if (!file) {
        *error = fault();
        return NULL;
    }
    struct in_order *o = xcalloc(1, sizeof *o);
    o->file = file;
    return o;
}

void in_order_stream(struct in_order *o)
{
    off_t at = ftello(o->file);
    if (o->count == o->room) {
        o->room = 2 * o->room + 16;
        o->streams = xreallocarray(o->streams, o->room, sizeof *o->streams);
    }
    o->streams[o->count++] = (struct stream){.at = at, .end = at};
}

void in_order_line(struct in_order *o, vtime time, const char *format, ...)
{
    char text[MOST_BYTES];
    struct stream *s = &o->streams[o->count - 1];
    va_list list;
    va_start(list, format);
    int bytes = vsnprintf(text, sizeof text, format, list);
    va_end(list);
    assert(bytes >= 0 && bytes < MOST_BYTES);
    struct head h = {vt_max(time, s->last), (uint32_t)bytes};
    fwrite(&h, sizeof h, 1, o->file);
    fwrite(text, 1, h.bytes, o->file);
    s->end += (off_t)(sizeof h + h.bytes);
    s->last = h.time;
}

/* --- merging --- */

static struct head head_of(const struct stream *s)
{
    struct head h;
    memcpy(&h, s->buffer + s->from, sizeof h);
    return h;
}

/* Has the buffer hold the stream's next line whole. False: there is none, or *failed. */
static bool fill(struct in_order *o, struct stream *s, bool *failed)
{
    size_t have = s->to - s->from;
    if (have >= sizeof(struct head) && have >= sizeof(struct head) + head_of(s).bytes)
        return true;
    memmove(s->buffer, s->buffer + s->from, have);
    size_t want = BUFFER - have;
    if ((off_t)want > s->end - s->at)
        want = (size_t)(s->end - s->at);
    ssize_t got = pread(fileno(o->file), s->buffer + have, want, s->at);
    *failed |= got != (ssize_t)want;
    s->from = 0, s->to = have + (got > 0 ? (size_t)got : 0), s->at += (off_t)want;
    return s->to > 0 && !*failed;
}

static bool before(const struct in_order *o, size_t a, size_t b)
{
    vtime ta = head_of(&o->streams[a]).time, tb = head_of(&o->streams[b]).time;
    return ta < tb || (ta == tb && a < b);
}

static void sink(struct in_order *o, size_t i)
{
    for (size_t least = i;; i = least) {
        for (size_t child = 2 * i + 1; child <= 2 * i + 2 && child < o->heaped; child++)
            if (before(o, o->heap[child], o->heap[least]))
                least = child;
        if (least == i)
            return;
        size_t stream = o->heap[i];
        o->heap[i] = o->heap[least], o->heap[least] = stream;
    }
}

static void heap_all(struct in_order *o, bool *failed)
{
    o->heap = xreallocarray(NULL, o->count, sizeof *o->heap);
    for (size_t i = 0; i < o->count; i++) {
        o->streams[i].buffer = xmalloc(BUFFER);
        if (fill(o, &o->streams[i], failed))
            o->heap[o->heaped++] = i;
    }
    for (size_t i = o->heaped; i-- > 0;)
        sink(o, i);
}

bool in_order_write(struct in_order *o, FILE *out, char **error)
{
    errno = 0;
    bool failed = ferror(o->file) || fflush(o->file) != 0;
    if (!failed)
        heap_all(o, &failed);
    while (o->heaped > 0 && !failed && !ferror(out)) {
        struct stream *s = &o->streams[o->heap[0]];
        struct head h = head_of(s);
        fwrite(s->buffer + s->from + sizeof h, 1, h.bytes, out);
        s->from += sizeof h + h.bytes;
        if (!fill(o, s, &failed))
            o->heap[0] = o->heap[--o->heaped];
        sink(o, 0);
    }
    if (failed)
        *error = fault();
    return !failed;
}

void in_order_free(struct in_order *o)
{
    for (size_t i = 0; i < o->count; i++)
        free(o->streams[i].buffer);
    free(o->streams);
    free(o->heap);
    fclose(o->file);
    free(o);
}
