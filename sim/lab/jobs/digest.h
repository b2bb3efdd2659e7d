/* digest.h - the first 128 bits of a SHA-256: identifies a point's inputs. Equal digests are taken to mean
 * equal bytes: finding two inputs of one digest would take some 2^64 attempts. */
#ifndef LAB_JOBS_DIGEST_H
#define LAB_JOBS_DIGEST_H
#include <jansson.h>
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

/* The digest of a value as JSON, whatever the order of its members. */
struct digest digest_of_json(const json_t *value);

/* To and from hexadecimal digits; digest_read() does not need a 0 after them. */
struct digest_text {
    char text[DIGEST_DIGITS + 1];
};
struct digest_text digest_text(struct digest d);
bool digest_read(const char *text, struct digest *d);
json_t *digest_json(struct digest d);
/* Sets a member to the digest of a file's bytes. False with *error malloc'd. */
bool digest_set_file(json_t *object, const char *key, const char *path, char **error);

static inline bool digest_equal(struct digest a, struct digest b)
{
    return a.high == b.high && a.low == b.low;
}
#endif
