/* data_blob.c - see data_blob.h. */
#include "lab/page/data_blob.h"
#include <stdint.h>
#include "kernel/xalloc.h"

enum { DEFLATED_PART = 3 << 14 };

void data_blob_begin(struct data_blob *b, FILE *out)
{
    *b = (struct data_blob){.out = out};
    if (deflateInit(&b->deflated, 6) != Z_OK)
        xexhausted();
    base64_encode_init(&b->base64);
}

/* Deflates what is at next_in, and writes what comes out. */
static void drain(struct data_blob *b, int flush)
{
    uint8_t part[DEFLATED_PART];
    char text[BASE64_ENCODE_LENGTH(DEFLATED_PART)];
    do {
        b->deflated.next_out = part;
        b->deflated.avail_out = sizeof part;
        deflate(&b->deflated, flush);
        size_t n = base64_encode_update(&b->base64, text, sizeof part - b->deflated.avail_out, part);
        fwrite(text, 1, n, b->out);
    } while (b->deflated.avail_out == 0);
}

void data_blob_add(struct data_blob *b, const void *bytes, size_t size)
{
    const uint8_t *at = bytes;
    while (size) {
        size_t n = size < UINT32_MAX ? size : UINT32_MAX;
        b->deflated.next_in = (z_const Bytef *)(uintptr_t)at;
        b->deflated.avail_in = (uInt)n;
        drain(b, Z_NO_FLUSH);
        at += n;
        size -= n;
    }
}

void data_blob_end(struct data_blob *b)
{
    char text[BASE64_ENCODE_FINAL_LENGTH];
    drain(b, Z_FINISH);
    deflateEnd(&b->deflated);
    fwrite(text, 1, base64_encode_final(&b->base64, text), b->out);
}
