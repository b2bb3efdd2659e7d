/* unpacker.h - reads what packer.h writes. A stream that ends early, or is damaged, reads as zeros from
 * there on: unpacker_good() tells. */
#ifndef TRACE_UNPACKER_H
#define TRACE_UNPACKER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

struct unpacker;

struct unpacker *unpacker_new(FILE *in);
void unpacker_free(struct unpacker *u);
/* Has all been there that has been asked for? */
bool unpacker_good(const struct unpacker *u);
uint8_t unpack_byte(struct unpacker *u);
uint64_t unpack(struct unpacker *u);
int64_t unpack_signed(struct unpacker *u);
/* A text, malloc'd. At most `most` bytes: else the stream is damaged. */
char *unpack_text(struct unpacker *u, size_t most);
#endif
