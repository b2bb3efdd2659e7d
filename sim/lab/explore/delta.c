/* delta.c - see delta.h. */
#include "lab/explore/delta.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

struct delta {
    unsigned char *kept;
    size_t count, tests;
    delta_test *test;
    void *arg;
};

static size_t size_of(const unsigned char *part, size_t count)
{
    size_t size = 0;
    for (size_t i = 0; i < count; i++)
        size += part[i];
    return size;
}

/* The at-th of so many equal chunks of what is kept, or all but that chunk. */
static unsigned char *part_of(const struct delta *d, size_t size, size_t at, size_t chunks, bool rest)
{
    unsigned char *part = xcalloc(d->count, 1);
    size_t begin = size * at / chunks, end = size * (at + 1) / chunks, seen = 0;
    for (size_t i = 0; i < d->count; i++)
        if (d->kept[i]) {
            part[i] = (seen >= begin && seen < end) != rest;
            seen++;
        }
    return part;
}

/* Tests all chunks, or all rests; takes the first that shows. *taken says whether there is one. False: no
 * more tests. */
static bool try_parts(struct delta *d, size_t chunks, bool rest, bool *taken)
{
    size_t size = size_of(d->kept, d->count);
    unsigned char **part = xcalloc(chunks, sizeof *part);
    bool *shows = xcalloc(chunks, sizeof *shows), able = d->tests >= chunks;
    for (size_t i = 0; i < chunks; i++)
        part[i] = part_of(d, size, i, chunks, rest);
    if (able) {
        d->tests -= chunks;
        able = d->test(d->arg, part, chunks, shows);
    }
    *taken = false;
    for (size_t i = 0; i < chunks; i++) {
        if (able && shows[i] && !*taken) {
            memcpy(d->kept, part[i], d->count);
            *taken = true;
        }
        free(part[i]);
    }
    free(part);
    free(shows);
    return able;
}

/* Does it show without any? */
static bool try_none(struct delta *d, bool *taken)
{
    unsigned char *none = xcalloc(d->count + 1, 1);
    bool able = d->tests > 0;
    *taken = false;
    if (able) {
        d->tests--;
        able = d->test(d->arg, &none, 1, taken);
    }
    if (able && *taken)
        memset(d->kept, 0, d->count);
    free(none);
    return able;
}

/* Halves first; a chunk that shows is gone on with in halves, a rest in as many chunks less one; otherwise in
 * twice as many, until each is one item. */
static bool narrow(struct delta *d)
{
    size_t chunks = 2, size;
    while ((size = size_of(d->kept, d->count)) >= 2) {
        bool taken;
        if (!try_parts(d, chunks, false, &taken))
            return false;
        if (taken) {
            chunks = 2;
            continue;
        }
        if (chunks > 2 && !try_parts(d, chunks, true, &taken)) /* the rest of one half is the other */
            return false;
        if (taken)
            chunks--;
        else if (chunks == size)
            return true;
        else
            chunks = 2 * chunks < size ? 2 * chunks : size;
    }
    return true;
}

bool delta_least(unsigned char *kept, size_t count, size_t tests, delta_test *test, void *arg)
{
    struct delta d = {kept, count, tests, test, arg};
    bool shows;
    memset(kept, 1, count);
    if (!try_none(&d, &shows))
        return false;
    return shows || narrow(&d);
}
