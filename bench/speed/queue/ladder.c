/* ladder.c - a ladder queue: far events lie unsorted in one array (top), nearer events in buckets by time
 * (rungs, each of which divides one bucket of the rung above), and only the nearest few events are sorted
 * (bottom). Tang, Goh, Thng, ACM TOMACS 15 (2005). Events of one time cannot be divided by time: such a
 * bucket is sorted whatever its size. */
#include <stdlib.h>
#include <string.h>
#include "queues.h"

enum { RUNGS = 8, BUCKETS = 64, SORTED = 48 };

struct pile {
    struct item *at;
    size_t count, room;
};

struct rung {
    uint64_t start, width; /* of the rung, of one bucket */
    size_t current, buckets;
    struct pile bucket[BUCKETS];
};

struct ladder {
    struct pile top, bottom; /* bottom: sorted; the earliest event is last */
    uint64_t top_start, least, most;
    int depth; /* rungs in use */
    struct rung rung[RUNGS];
};

static void *make(void)
{
    return calloc(1, sizeof(struct ladder));
}

static void add(struct pile *p, struct item e)
{
    if (p->count == p->room) {
        p->room = 2 * p->room + 16;
        p->at = realloc(p->at, p->room * sizeof *p->at);
    }
    p->at[p->count++] = e;
}

static uint64_t now_at(const struct rung *r)
{
    return r->start + r->current * r->width;
}

static void insert(struct pile *p, struct item e)
{
    add(p, e);
    size_t i = p->count - 1;
    for (; i > 0 && item_before(p->at[i - 1], e); i--)
        p->at[i] = p->at[i - 1];
    p->at[i] = e;
}

static void put(void *queue, struct item e)
{
    struct ladder *q = queue;
    if (e.time >= q->top_start) {
        if (q->top.count == 0)
            q->least = q->most = e.time;
        q->least = e.time < q->least ? e.time : q->least;
        q->most = e.time > q->most ? e.time : q->most;
        add(&q->top, e);
        return;
    }
    for (int i = 0; i < q->depth; i++) {
        struct rung *r = &q->rung[i];
        if (e.time >= now_at(r)) {
            add(&r->bucket[(e.time - r->start) / r->width], e);
            return;
        }
    }
    insert(&q->bottom, e);
}

/* Spreads a pile of events between least and most over a new rung. */
static void spread(struct ladder *q, struct pile *p, uint64_t least, uint64_t most)
{
    struct rung *r = &q->rung[q->depth++];
    r->start = least;
    r->width = (most - least) / BUCKETS + 1;
    r->current = 0;
    r->buckets = BUCKETS;
    for (size_t i = 0; i < p->count; i++)
        add(&r->bucket[(p->at[i].time - least) / r->width], p->at[i]);
    p->count = 0;
}

static int later_first(const void *a, const void *b)
{
    return item_before(*(const struct item *)a, *(const struct item *)b) ? 1 : -1;
}

/* Moves the next events to bottom. */
static void refill(struct ladder *q)
{
    for (;;) {
        if (q->depth == 0) {
            uint64_t least = q->least, most = q->most;
            spread(q, &q->top, least, most);
            q->top_start = q->rung[0].start + BUCKETS * q->rung[0].width;
        }
        struct rung *r = &q->rung[q->depth - 1];
        while (r->current < r->buckets && r->bucket[r->current].count == 0)
            r->current++;
        if (r->current == r->buckets) {
            q->depth--;
            continue;
        }
        struct pile *p = &r->bucket[r->current++];
        uint64_t start = now_at(r) - r->width;
        if (p->count > SORTED && r->width > 1 && q->depth < RUNGS) {
            spread(q, p, start, start + r->width - 1);
            continue;
        }
        struct pile t = q->bottom;
        q->bottom = *p;
        *p = t;
        p->count = 0;
        qsort(q->bottom.at, q->bottom.count, sizeof *q->bottom.at, later_first);
        return;
    }
}

static struct item take(void *queue)
{
    struct ladder *q = queue;
    if (q->bottom.count == 0)
        refill(q);
    return q->bottom.at[--q->bottom.count];
}

static void drop(void *queue)
{
    struct ladder *q = queue;
    free(q->top.at);
    free(q->bottom.at);
    for (int i = 0; i < RUNGS; i++)
        for (int b = 0; b < BUCKETS; b++)
            free(q->rung[i].bucket[b].at);
    free(q);
}

const struct queue LADDER = {"ladder queue", make, put, take, drop};
