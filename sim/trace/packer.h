/* packer.h - numbers and texts as a compressed stream of bytes (trace_format.h), and back. */
#ifndef TRACE_PACKER_H
#define TRACE_PACKER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* The longest number takes so many bytes. */
enum { PACK_LONGEST = 10 };

struct packer_room {
    uint8_t *at, *end;
};

/* A stream that is being written. */
struct packer {
    struct packer_room room; /* of the bytes that are not compressed yet; at least PACK_LONGEST are free */
};

struct packer *packer_new(FILE *out);
/* Writes what is left, and frees the packer; out stays open. Errors are left in `out`. */
void packer_end(struct packer *p);
void packer_flush(struct packer *p);

static inline void packer_make_room(struct packer *p)
{
    if (p->room.end - p->room.at < PACK_LONGEST)
        packer_flush(p);
}

static inline void pack_kind(struct packer *p, uint8_t kind)
{
    packer_make_room(p);
    *p->room.at++ = kind;
}

static inline void pack(struct packer *p, uint64_t n)
{
    packer_make_room(p);
    uint8_t *at = p->room.at;
    for (; n >= 128; n >>= 7)
        *at++ = (uint8_t)(n | 128);
    *at++ = (uint8_t)n;
    p->room.at = at;
}

static inline void pack_signed(struct packer *p, int64_t n)
{
    pack(p, (uint64_t)n << 1 ^ (uint64_t)(n >> 63));
}

/* A length and so many bytes. */
void pack_bytes(struct packer *p, const void *bytes, size_t length);
#endif
