/* packer.h - numbers and texts as a compressed stream of bytes (trace_format.h), and back. */
#ifndef TRACE_PACKER_H
#define TRACE_PACKER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* The longest number takes so many bytes. */
enum { PACK_LONGEST = 10 };

/* A stream that is being written: the room for bytes that are not compressed yet. */
struct packer {
    uint8_t *at, *end;
};

struct packer *packer_new(FILE *out);
/* Writes what is left, and frees the packer; out stays open. Errors are left in `out`. */
void packer_end(struct packer *p);
void packer_flush(struct packer *p);

/* Where the next bytes go: there is room for so many numbers. Where they end, packer_wrote() is told. */
static inline uint8_t *packer_room(struct packer *p, unsigned numbers)
{
    if (p->end - p->at < (ptrdiff_t)numbers * PACK_LONGEST)
        packer_flush(p);
    return p->at;
}

static inline void packer_wrote(struct packer *p, uint8_t *end)
{
    p->at = end;
}

static inline void put(uint8_t **at, uint64_t n)
{
    uint8_t *to = *at;
    for (; n >= 128; n >>= 7)
        *to++ = (uint8_t)(n | 128);
    *to++ = (uint8_t)n;
    *at = to;
}

static inline void put_signed(uint8_t **at, int64_t n)
{
    put(at, (uint64_t)n << 1 ^ (uint64_t)(n >> 63));
}

static inline void pack(struct packer *p, uint64_t n)
{
    uint8_t *at = packer_room(p, 1);
    put(&at, n);
    packer_wrote(p, at);
}

static inline void pack_byte(struct packer *p, uint8_t byte)
{
    uint8_t *at = packer_room(p, 1);
    *at = byte;
    packer_wrote(p, at + 1);
}

/* A length and so many bytes. */
void pack_bytes(struct packer *p, const void *bytes, size_t length);
#endif
