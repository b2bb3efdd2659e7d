/* race_findings.c - see race_findings.h. */
#include "races/race_findings.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

enum { BUCKETS = 1024 };

/* The places of a pair, in an order that does not depend on which came earlier. */
static uint64_t pair_of(const struct race_finding *f)
{
    uint64_t a = f->earlier.place, b = f->later.place;
    return a < b ? a << 32 | b : b << 32 | a;
}

static struct race_finding *find(const struct race_findings *t, const struct race_finding *f, uint32_t bucket)
{
    for (uint32_t i = t->buckets[bucket]; i; i = t->list[i].next)
        if (t->list[i].what == f->what && pair_of(&t->list[i]) == pair_of(f))
            return &t->list[i];
    return NULL;
}

static void make_room(struct race_findings *t)
{
    if (!t->buckets) {
        t->buckets = xcalloc(BUCKETS, sizeof *t->buckets);
        t->count = 1;
    }
    if (t->count >= t->room)
        t->list = xreallocarray(t->list, t->room = t->room ? 2 * t->room : 16, sizeof *t->list);
}

void race_findings_add(struct race_findings *t, const struct race_finding *f)
{
    make_room(t);
    if (!f->earlier.place || !f->later.place) {
        t->dropped++;
        return;
    }
    uint32_t bucket = (uint32_t)((pair_of(f) * UINT64_C(0x9e3779b97f4a7c15)) >> 40) % BUCKETS;
    struct race_finding *there = find(t, f, bucket);
    if (there) {
        if (there->segment != t->segment)
            there->segment = t->segment, there->before = there->count;
        there->count++;
    } else if (t->count == RACE_MOST_FINDINGS) {
        t->dropped++;
    } else {
        struct race_finding *new = &t->list[t->count];
        *new = *f;
        new->count = 1, new->before = 0, new->segment = t->segment;
        new->next = t->buckets[bucket];
        t->buckets[bucket] = t->count++;
    }
}

void race_findings_begin_segment(struct race_findings *t)
{
    t->segment++;
    t->dropped_before = t->dropped;
}

void race_findings_forget_segment(struct race_findings *t)
{
    for (uint32_t i = 1; i < t->count; i++)
        if (t->list[i].segment == t->segment)
            t->list[i].count = t->list[i].before;
    t->dropped = t->dropped_before;
}

void race_findings_end(struct race_findings *t)
{
    free(t->list);
    free(t->buckets);
    *t = (struct race_findings){0};
}
