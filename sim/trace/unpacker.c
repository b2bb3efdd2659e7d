/* unpacker.c - see unpacker.h. */
#include "trace/unpacker.h"
#include <stdlib.h>
#include <zstd.h>
#include "kernel/xalloc.h"

struct unpacker {
    FILE *in;
    ZSTD_DCtx *zstd;
    bool bad;
    ZSTD_inBuffer raw;
    uint8_t *bytes, *at, *end;
    size_t room, raw_room;
};

struct unpacker *unpacker_new(FILE *in)
{
    struct unpacker *u = xcalloc(1, sizeof *u);
    u->in = in;
    u->zstd = xchecked(ZSTD_createDCtx());
    u->room = ZSTD_DStreamOutSize(), u->raw_room = ZSTD_DStreamInSize();
    u->at = u->end = u->bytes = xmalloc(u->room);
    u->raw.src = xmalloc(u->raw_room);
    return u;
}

void unpacker_free(struct unpacker *u)
{
    ZSTD_freeDCtx(u->zstd);
    free(u->bytes);
    free((void *)(uintptr_t)u->raw.src);
    free(u);
}

bool unpacker_good(const struct unpacker *u)
{
    return !u->bad;
}

/* Decompresses more. False: there is no more. */
static bool refill(struct unpacker *u)
{
    ZSTD_outBuffer out = {u->bytes, u->room, 0};
    while (out.pos == 0) {
        if (u->raw.pos == u->raw.size) {
            u->raw.size = fread((void *)(uintptr_t)u->raw.src, 1, u->raw_room, u->in);
            u->raw.pos = 0;
            if (!u->raw.size)
                return false;
        }
        if (ZSTD_isError(ZSTD_decompressStream(u->zstd, &out, &u->raw)))
            return false;
    }
    u->at = u->bytes, u->end = u->bytes + out.pos;
    return true;
}

uint8_t unpack_byte(struct unpacker *u)
{
    if (u->at == u->end && (u->bad || !refill(u))) {
        u->bad = true;
        return 0;
    }
    return *u->at++;
}

uint64_t unpack(struct unpacker *u)
{
    uint64_t n = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        uint8_t byte = unpack_byte(u);
        n |= (uint64_t)(byte & 127) << shift;
        if (byte < 128)
            return n;
    }
    u->bad = true;
    return 0;
}

int64_t unpack_signed(struct unpacker *u)
{
    uint64_t n = unpack(u);
    return (int64_t)(n >> 1 ^ -(n & 1));
}

char *unpack_text(struct unpacker *u, size_t most)
{
    uint64_t length = unpack(u);
    if (length > most)
        u->bad = true, length = 0;
    char *text = xmalloc(length + 1);
    for (size_t i = 0; i < length; i++)
        text[i] = (char)unpack_byte(u);
    text[length] = '\0';
    return text;
}
