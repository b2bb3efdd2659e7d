/* data_blob.h - bytes in an HTML file: deflated (zlib's format), then base64, so that no byte of them can be
 * mistaken for markup. Browsers read them by atob() and DecompressionStream("deflate"). */
#ifndef LAB_PAGE_DATA_BLOB_H
#define LAB_PAGE_DATA_BLOB_H
#include <nettle/base64.h>
#include <stddef.h>
#include <stdio.h>
#include <zlib.h>

struct data_blob {
    FILE *out;
    z_stream deflated;
    struct base64_encode_ctx base64;
};

/* Errors of writing stay with the stream: ferror(). */
void data_blob_begin(struct data_blob *b, FILE *out);
void data_blob_add(struct data_blob *b, const void *bytes, size_t size);
void data_blob_end(struct data_blob *b);
#endif
