/* digest.c - see digest.h. SHA-256 is Nettle's. */
#include "lab/jobs/digest.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"

#include <inttypes.h>
#include <nettle/sha2.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct digest end(struct sha256_ctx *sha)
{
    uint8_t bytes[SHA256_DIGEST_SIZE];
    struct digest d = {0};
    sha256_digest(sha, sizeof bytes, bytes);
    for (int i = 0; i < 8; i++) {
        d.high = d.high << 8 | bytes[i];
        d.low = d.low << 8 | bytes[8 + i];
    }
    return d;
}

struct digest digest_of(const void *bytes, size_t size)
{
    struct sha256_ctx sha;
    sha256_init(&sha);
    sha256_update(&sha, size, bytes);
    return end(&sha);
}

bool digest_file(const char *path, struct digest *d)
{
    struct sha256_ctx sha;
    uint8_t part[1 << 16];
    FILE *in = fopen(path, "re");
    if (!in)
        return false;
    sha256_init(&sha);
    for (size_t n; (n = fread(part, 1, sizeof part, in)) > 0;)
        sha256_update(&sha, n, part);
    bool read = !ferror(in);
    fclose(in);
    *d = end(&sha);
    return read;
}

struct digest digest_of_json(const json_t *value)
{
    char *text = xchecked(json_dumps(value, JSON_COMPACT | JSON_SORT_KEYS));
    struct digest d = digest_of(text, strlen(text));
    free(text);
    return d;
}

struct digest_text digest_text(struct digest d)
{
    struct digest_text t;
    snprintf(t.text, sizeof t.text, "%016" PRIx64 "%016" PRIx64, d.high, d.low);
    return t;
}

json_t *digest_json(struct digest d)
{
    return json_string(digest_text(d).text);
}

bool digest_set_file(json_t *object, const char *key, const char *path, char **error)
{
    struct digest d;
    if (!digest_file(path, &d)) {
        *error = xasprintf("%s cannot be read: %m", path);
        return false;
    }
    json_set(object, key, digest_json(d));
    return true;
}

bool digest_read(const char *text, struct digest *d)
{
    static const char digits[] = "0123456789abcdef";
    uint64_t half[2] = {0};
    for (int i = 0; i < DIGEST_DIGITS; i++) {
        const char *at = text[i] ? strchr(digits, text[i]) : NULL;
        if (!at)
            return false;
        half[i / 16] = half[i / 16] << 4 | (uint64_t)(at - digits);
    }
    *d = (struct digest){half[0], half[1]};
    return true;
}
