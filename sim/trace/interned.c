/* interned.c - see interned.h: a hash table with open addressing, at most half full. */
#include "trace/interned.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

struct string {
    void *bytes;
    size_t length;
    uint64_t hash;
};

struct interned {
    struct string *strings;
    uint32_t count, room;
    uint32_t *slots;     /* number +1; 0: free */
    uint32_t slot_count; /* a power of two */
};

struct interned *interned_new(void)
{
    struct interned *t = xcalloc(1, sizeof *t);
    t->slot_count = 64;
    t->slots = xcalloc(t->slot_count, sizeof *t->slots);
    return t;
}

void interned_free(struct interned *t)
{
    for (uint32_t i = 0; i < t->count; i++)
        free(t->strings[i].bytes);
    free(t->strings);
    free(t->slots);
    free(t);
}

/* FNV-1a, eight bytes at a time. */
static uint64_t hash_of(const unsigned char *bytes, size_t length)
{
    uint64_t hash = 0xcbf29ce484222325, word;
    for (; length >= sizeof word; bytes += sizeof word, length -= sizeof word) {
        memcpy(&word, bytes, sizeof word);
        hash = (hash ^ word) * 0x100000001b3;
        hash ^= hash >> 29;
    }
    for (; length; length--)
        hash = (hash ^ *bytes++) * 0x100000001b3;
    return hash ^ hash >> 32;
}

static uint32_t free_slot(const struct interned *t, uint64_t hash)
{
    uint32_t i = (uint32_t)hash & (t->slot_count - 1);
    while (t->slots[i])
        i = (i + 1) & (t->slot_count - 1);
    return i;
}

static void grow(struct interned *t)
{
    free(t->slots);
    t->slot_count *= 2;
    t->slots = xcalloc(t->slot_count, sizeof *t->slots);
    for (uint32_t i = 0; i < t->count; i++)
        t->slots[free_slot(t, t->strings[i].hash)] = i + 1;
}

static bool is(const struct string *s, uint64_t hash, const void *bytes, size_t length)
{
    return s->hash == hash && s->length == length && !memcmp(s->bytes, bytes, length);
}

static uint32_t add(struct interned *t, uint64_t hash, const void *bytes, size_t length)
{
    if (2 * (t->count + 1) > t->slot_count)
        grow(t);
    if (t->count == t->room) {
        t->room = t->room ? 2 * t->room : 16;
        t->strings = xreallocarray(t->strings, t->room, sizeof *t->strings);
    }
    void *copy = xmalloc(length);
    memcpy(copy, bytes, length);
    t->strings[t->count] = (struct string){copy, length, hash};
    t->slots[free_slot(t, hash)] = ++t->count;
    return t->count - 1;
}

uint32_t interned_number(struct interned *t, const void *bytes, size_t length, bool *is_new)
{
    uint64_t hash = hash_of(bytes, length);
    *is_new = false;
    for (uint32_t i = (uint32_t)hash & (t->slot_count - 1); t->slots[i]; i = (i + 1) & (t->slot_count - 1))
        if (is(&t->strings[t->slots[i] - 1], hash, bytes, length))
            return t->slots[i] - 1;
    *is_new = true;
    return add(t, hash, bytes, length);
}
