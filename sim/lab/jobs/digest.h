/* digest.h - what a point's inputs are called: the first 128 bits of their SHA-256. Equal digests mean equal bytes: two
 * different inputs of one digest have never been found, by anybody. */
#ifndef LAB_JOBS_DIGEST_H
#define LAB_JOBS_DIGEST_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct digest {
    uint64_t high, low;
};
enum { DIGEST_DIGITS = 32 };

struct digest digest_of(const void *bytes, size_t size);
/* Of a file's bytes; false with errno. */
bool digest_file(const char *path, struct digest *d);

/* In hexadecimal, and back; text needs no end after the digits. */
void digest_write(struct digest d, char text[DIGEST_DIGITS + 1]);
bool digest_read(const char *text, struct digest *d);

static inline bool digest_equal(struct digest a, struct digest b)
{
    return a.high == b.high && a.low == b.low;
}
#endif
