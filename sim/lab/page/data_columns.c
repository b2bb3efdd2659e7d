/* data_columns.c - see data_columns.h. */
#include "lab/page/data_columns.h"
#include <stdlib.h>
#include <string.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"

enum { PART = 1 << 14 };

static const struct {
    const char *name;
    size_t bytes, halves;
} TYPES[] = {[COLUMN_U8] = {"u8", 1, 1},
             [COLUMN_U16] = {"u16", 2, 1},
             [COLUMN_I32] = {"i32", 4, 1},
             [COLUMN_U64] = {"u64", 4, 2},
             [COLUMN_F32] = {"f32", 4, 1}};

static void pad(struct data_blob *b, size_t written, char with)
{
    char filler[8];
    memset(filler, with, sizeof filler);
    data_blob_add(b, filler, -written % 8);
}

static void write_header(struct data_blob *b, json_t *header, const struct column *columns, size_t count)
{
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++) {
        const struct column *c = &columns[i];
        json_t *j = json_pack("{s:s, s:s, s:I}", "name", c->name, "type", TYPES[c->type].name, "count",
                              (json_int_t)c->count);
        if (c->base)
            json_set(j, "base", json_string(c->base));
        json_append(list, j);
    }
    json_set(header, "columns", list);
    char *text = xchecked(json_dumps(header, JSON_COMPACT | JSON_REAL_PRECISION(17)));
    size_t length = strlen(text);
    uint64_t padded = length + -length % 8;
    data_blob_add(b, &padded, sizeof padded);
    data_blob_add(b, text, length);
    pad(b, length, ' ');
    free(text);
    json_decref(header);
}

static const struct column *find(const struct column *columns, const char *name)
{
    while (strcmp(columns->name, name))
        columns++;
    return columns;
}

/* Writes half `half` of all numbers of a column. base: NULL, or the column that its base names. */
static void write_half(struct data_blob *b, const struct column *c, const struct column *base, size_t half)
{
    size_t bytes = TYPES[c->type].bytes, used = 0;
    uint64_t before = 0;
    char part[PART];
    for (size_t i = 0; i < c->count; i++) {
        uint64_t v = c->value(c->of, i), difference = v;
        if (base)
            difference = v - base->value(base->of, i);
        else if (c->base)
            difference = v - before;
        before = v;
        difference >>= 32 * half;
        memcpy(part + used, &difference, bytes); /* the host is little-endian: sim/guest needs x86-64 */
        used += bytes;
        if (used == PART || i + 1 == c->count)
            data_blob_add(b, part, used), used = 0;
    }
}

void data_columns_write(struct data_blob *b, json_t *header, const struct column *columns, size_t count)
{
    write_header(b, header, columns, count);
    for (size_t i = 0; i < count; i++) {
        const struct column *c = &columns[i];
        const struct column *base = c->base && *c->base ? find(columns, c->base) : NULL;
        for (size_t half = 0; half < TYPES[c->type].halves; half++)
            write_half(b, c, base, half);
        pad(b, c->count * TYPES[c->type].bytes * TYPES[c->type].halves, 0);
    }
}
