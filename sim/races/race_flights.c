/* race_flights.c - see race_flights.h. */
#include "races/race_flights.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

static void forget_gap(struct race_flights *f)
{
    f->gap_begin = f->gap_end = 0;
}

void race_flights_end(struct race_flights *f)
{
    for (uint32_t i = 0; i < f->count; i++)
        race_clock_free(f->list[i].heard);
    free(f->list);
    *f = (struct race_flights){0};
}

void race_flights_add(struct race_flights *f, const struct race_flight *flight)
{
    if (f->count == f->room)
        f->list = xreallocarray(f->list, f->room = f->room ? 2 * f->room : 8, sizeof *f->list);
    f->list[f->count++] = *flight;
    forget_gap(f);
}

bool race_flights_remove(struct race_flights *f, const void *key, struct race_flight *flight)
{
    for (uint32_t i = 0; i < f->count; i++) {
        if (f->list[i].key != key)
            continue;
        *flight = f->list[i];
        f->count--;
        for (; i < f->count; i++) /* in the order in which they began: reports name the first */
            f->list[i] = f->list[i + 1];
        forget_gap(f);
        return true;
    }
    return false;
}

void race_flights_keep(struct race_flights *f, bool (*lives)(const void *ctx, const struct race_flight *),
                       const void *ctx)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < f->count; i++) {
        if (lives(ctx, &f->list[i]))
            f->list[kept++] = f->list[i];
        else
            race_clock_free(f->list[i].heard);
    }
    f->count = kept;
    forget_gap(f);
}

static bool overlaps(const struct race_flight *a, uintptr_t begin, uintptr_t end)
{
    return a->begin < a->end && a->begin < end && begin < a->end;
}

const struct race_flight *race_flights_next(const struct race_flights *f, uintptr_t begin, uintptr_t end,
                                            bool write, uint32_t *from)
{
    while (*from < f->count) {
        const struct race_flight *a = &f->list[(*from)++];
        if ((write || a->receives) && overlaps(a, begin, end))
            return a;
    }
    return NULL;
}

void race_flights_find_gap(struct race_flights *f, uintptr_t begin, uintptr_t end)
{
    uintptr_t low = 0, high = UINTPTR_MAX;
    for (uint32_t i = 0; i < f->count; i++) {
        const struct race_flight *a = &f->list[i];
        if (overlaps(a, begin, end))
            return;
        if (a->end <= begin && a->end > low)
            low = a->end;
        if (a->begin >= end && a->begin < high)
            high = a->begin;
    }
    f->gap_begin = low, f->gap_end = high;
}
