/* digest.h - the first 128 bits of a SHA-256: identifies a point's inputs. Equal digests are taken to mean
 * equal bytes: finding two inputs of one digest would take some 2^64 attempts. */
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
/* The digest of a file's bytes. False with errno. */
bool digest_file(const char *path, struct digest *d);

/* To and from hexadecimal digits; digest_read() does not need a 0 after them. */
void digest_write(struct digest d, char text[DIGEST_DIGITS + 1]);
bool digest_read(const char *text, struct digest *d);

static inline bool digest_equal(struct digest a, struct digest b)
{
    return a.high == b.high && a.low == b.low;
}
#endif
