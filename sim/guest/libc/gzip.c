/* gzip.c - zlib's gzopen and its related calls for node programs, over the node's own files: reading a
 * compressed file of the Concurrent File System takes that file system's time. Files can only be read; a
 * plain file is read as it is, as by zlib. The decompressor's memory comes from the node's heap. The
 * processor's time is in the compiler's table of calls (gzread). */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>
#include "guest/heap.h"
#include "guest/libc/libc_parts.h"
#include "node/node.h"
#include "node/self.h"

struct gz {
    FILE *file;
    z_stream z;
    bool packed; /* otherwise plain */
    bool end;    /* no more data */
    bool past;   /* a read has asked for more than there was */
    int error;   /* Z_DATA_ERROR: the data are damaged; Z_BUF_ERROR: the file ends within a member */
    z_off_t at;
    unsigned char in[8192];
};

static voidpf take(voidpf n, uInt items, uInt size)
{
    return node_heap_alloc(((struct node *)n)->guest.heap, (size_t)items * size);
}

static void give_back(voidpf n, voidpf p)
{
    node_heap_release(((struct node *)n)->guest.heap, p);
}

/* Reads on if there are fewer bytes of input than needed; returns how many there are. */
static size_t fill(struct gz *g, size_t needed)
{
    size_t left = g->z.avail_in;
    if (left < needed) {
        memmove(g->in, g->z.next_in, left);
        g->z.next_in = g->in;
        g->z.avail_in += (uInt)fread(g->in + left, 1, sizeof g->in - left, g->file);
    }
    return g->z.avail_in;
}

static bool at_member(struct gz *g)
{
    return fill(g, 2) >= 2 && g->z.next_in[0] == 0x1f && g->z.next_in[1] == 0x8b;
}

/* Starts at the beginning of the file, and finds out whether the file is packed. */
static bool start(struct gz *g)
{
    g->end = g->past = false;
    g->error = Z_OK;
    g->at = 0;
    g->z.next_in = g->in, g->z.avail_in = 0;
    g->packed = at_member(g);
    return !g->packed || inflateReset(&g->z) == Z_OK;
}

gzFile node_gzopen(const char *path, const char *mode)
{
    enum { ANY_WINDOW_GZIP = 15 + 16 };
    struct node *n = node_self();
    if (strpbrk(mode, "wa+")) {
        errno = EINVAL;
        return NULL;
    }
    FILE *file = stream_fopen(streams_of(n), n, path, "rb");
    struct gz *g = file ? node_heap_alloc(n->guest.heap, sizeof *g) : NULL;
    if (!g)
        goto fail;
    *g = (struct gz){.file = file, .z = {.zalloc = take, .zfree = give_back, .opaque = n}};
    if (inflateInit2(&g->z, ANY_WINDOW_GZIP) != Z_OK)
        goto fail;
    if (start(g))
        return (gzFile)g;
    inflateEnd(&g->z);
fail:
    if (file)
        stream_fclose(streams_of(n), file);
    if (g)
        node_heap_release(n->guest.heap, g);
    return NULL;
}

/* A file may have several gzip members, one behind the other. Anything else behind a member ends the data. */
static bool next_member(struct gz *g)
{
    return at_member(g) && inflateReset(&g->z) == Z_OK;
}

static size_t read_packed(struct gz *g, void *buf, size_t size)
{
    g->z.next_out = buf;
    g->z.avail_out = (uInt)size;
    while (g->z.avail_out > 0 && !g->end && !g->error) {
        if (fill(g, 1) == 0) {
            g->error = Z_BUF_ERROR;
            break;
        }
        int r = inflate(&g->z, Z_NO_FLUSH);
        if (r == Z_STREAM_END)
            g->end = !next_member(g);
        else if (r != Z_OK && r != Z_BUF_ERROR)
            g->error = Z_DATA_ERROR;
    }
    return size - g->z.avail_out;
}

static size_t read_plain(struct gz *g, char *buf, size_t size)
{
    size_t got = g->z.avail_in < size ? g->z.avail_in : size;
    memcpy(buf, g->z.next_in, got);
    g->z.next_in += got;
    g->z.avail_in -= (uInt)got;
    got += fread(buf + got, 1, size - got, g->file);
    g->end = got < size;
    return got;
}

int node_gzread(gzFile file, voidp buf, unsigned size)
{
    struct gz *g = (struct gz *)file;
    size_t got = g->packed ? read_packed(g, buf, size) : read_plain(g, buf, size);
    g->at += (z_off_t)got;
    g->past = got < size;
    return g->error == Z_DATA_ERROR && got == 0 ? -1 : (int)got;
}

/* A place beyond the end is one, too. Returns false if the data are damaged. */
static bool skip_to(struct gz *g, z_off_t to)
{
    char waste[1024];
    int got = 1;
    while (g->at < to && got > 0) {
        z_off_t left = to - g->at;
        got = node_gzread((gzFile)g, waste, left < (z_off_t)sizeof waste ? (unsigned)left : sizeof waste);
    }
    return got >= 0;
}

z_off_t node_gzseek(gzFile file, z_off_t offset, int whence)
{
    struct gz *g = (struct gz *)file;
    z_off_t to = whence == SEEK_CUR ? g->at + offset : offset;
    if (whence == SEEK_END || to < 0)
        return -1;
    if (to < g->at) {
        rewind(g->file);
        if (!start(g))
            return -1;
    }
    return skip_to(g, to) ? to : -1;
}

int node_gzeof(gzFile file)
{
    return ((struct gz *)file)->past;
}

const char *node_gzerror(gzFile file, int *number)
{
    const struct gz *g = (const struct gz *)file;
    if (number)
        *number = g->error;
    const char *text = g->error == Z_DATA_ERROR  ? "the compressed data are damaged"
                       : g->error == Z_BUF_ERROR ? "the compressed data are cut short"
                                                 : "";
    return own_memory_text(node_self(), text);
}

int node_gzclose(gzFile file)
{
    struct gz *g = (struct gz *)file;
    struct node *n = node_self();
    bool cut = g->error == Z_BUF_ERROR;
    inflateEnd(&g->z);
    int r = stream_fclose(streams_of(n), g->file);
    node_heap_release(n->guest.heap, g);
    return r ? Z_ERRNO : cut ? Z_BUF_ERROR : Z_OK;
}
