/* packer.c - see packer.h. */
#include "trace/packer.h"
#include <stdlib.h>
#include <string.h>
#include <zstd.h>
#include "kernel/xalloc.h"

enum { ROOM = 1 << 15, LEVEL = 1 };

struct stream {
    struct packer packer;
    FILE *out;
    ZSTD_CCtx *zstd;
    uint8_t *compressed;
    size_t compressed_room;
    uint8_t bytes[ROOM];
};

struct packer *packer_new(FILE *out)
{
    struct stream *s = xmalloc(sizeof *s);
    s->packer = (struct packer){s->bytes, s->bytes + ROOM};
    s->out = out;
    s->zstd = xchecked(ZSTD_createCCtx());
    ZSTD_CCtx_setParameter(s->zstd, ZSTD_c_compressionLevel, LEVEL);
    s->compressed_room = ZSTD_CStreamOutSize();
    s->compressed = xmalloc(s->compressed_room);
    return &s->packer;
}

/* Compresses what has been packed. */
static void compress(struct stream *s, ZSTD_EndDirective how)
{
    ZSTD_inBuffer in = {s->bytes, (size_t)(s->packer.at - s->bytes), 0};
    size_t left;
    do {
        ZSTD_outBuffer out = {s->compressed, s->compressed_room, 0};
        left = ZSTD_compressStream2(s->zstd, &out, &in, how);
        if (ZSTD_isError(left))
            xexhausted(); /* nothing else can go wrong */
        fwrite(s->compressed, 1, out.pos, s->out);
    } while (how == ZSTD_e_end ? left > 0 : in.pos < in.size);
    s->packer.at = s->bytes;
}

void packer_flush(struct packer *p)
{
    compress((struct stream *)p, ZSTD_e_continue);
}

void packer_end(struct packer *p)
{
    struct stream *s = (struct stream *)p;
    compress(s, ZSTD_e_end);
    ZSTD_freeCCtx(s->zstd);
    free(s->compressed);
    free(s);
}

void pack_bytes(struct packer *p, const void *bytes, size_t length)
{
    pack(p, length);
    for (size_t i = 0; i < length; i++)
        pack_byte(p, ((const uint8_t *)bytes)[i]);
}
