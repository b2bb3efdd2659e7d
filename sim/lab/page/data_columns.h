/* data_columns.h - tables of numbers for the page: a header in JSON, then columns of little-endian
 * numbers.
 *
 *     8 bytes   length of the header in bytes, a multiple of 8
 *     header    what the caller gives, and "columns": [{name, type, count, base}], padded with spaces
 *     columns   in that order, each padded with zeros to a multiple of 8 bytes
 *
 * Integers may be written as differences, modulo 2^bits, which deflate better: from the number before
 * (base "": the first from 0), or from the same place of another, earlier column (base is its name).
 * Numbers of 64 bits stand as all their lower halves, then all their upper halves: a browser's numbers
 * hold 53 bits. */
#ifndef LAB_PAGE_DATA_COLUMNS_H
#define LAB_PAGE_DATA_COLUMNS_H
#include <jansson.h>
#include <stddef.h>
#include <stdint.h>
#include "lab/page/data_blob.h"

enum column_type { COLUMN_U8, COLUMN_U16, COLUMN_I32, COLUMN_U64, COLUMN_F32 };

/* The number at place i; of COLUMN_F32 its 32 bits. */
typedef uint64_t column_value(const void *of, size_t i);

struct column {
    const char *name;
    enum column_type type;
    size_t count;
    column_value *value;
    const void *of;
    const char *base; /* NULL: the numbers themselves */
};

/* Takes over header. */
void data_columns_write(struct data_blob *b, json_t *header, const struct column *columns, size_t count);
#endif
