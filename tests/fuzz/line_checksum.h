/* line_checksum.h - a line whose checksum is "--------" gets the right one: nobody guesses CRC-32. */
#ifndef LINE_CHECKSUM_H
#define LINE_CHECKSUM_H
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <zlib.h>

static inline void set_line_checksums(char *text, size_t size)
{
    for (char *at = text, *end = text + size, *next; at < end; at = next) {
        char *stop = memchr(at, '\n', (size_t)(end - at)), digits[9];
        next = stop ? stop + 1 : end;
        if (!stop || stop - at < 9 || memcmp(at, "--------", 8) != 0)
            continue;
        snprintf(digits, sizeof digits, "%08lx", crc32(0, (const Bytef *)at + 9, (uInt)(stop - at - 9)));
        memcpy(at, digits, 8);
    }
}
#endif
