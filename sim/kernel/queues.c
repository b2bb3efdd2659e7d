/* queues.c - see queues.h. A hash table of the numbers, each with its queue in a ring. */
#include "kernel/queues.h"
#include "kernel/xalloc.h"
#include <assert.h>
#include <stdlib.h>

struct entry {
    int64_t order;
    void *item;
};

struct queue {
    uint32_t number;
    uint32_t first, count, room; /* of the ring; room is a power of 2, or 0: nobody's place */
    struct entry *ring;
};

struct queues {
    struct queue *table;
    uint32_t used, room; /* a power of 2 */
};

struct queues *queues_new(void)
{
    struct queues *q = xcalloc(1, sizeof *q);
    q->room = 16;
    q->table = xcalloc(q->room, sizeof *q->table);
    return q;
}

void queues_free(struct queues *q)
{
    if (!q)
        return;
    for (uint32_t i = 0; i < q->room; i++)
        free(q->table[i].ring);
    free(q->table);
    free(q);
}

/* Where a number's queue is, or would be. */
static struct queue *place_of(const struct queues *q, uint32_t number)
{
    /* (The product's upper bits: the lower ones tell nothing of a number's upper ones.) */
    uint32_t i = (number * UINT32_C(2654435769)) >> (__builtin_clz(q->room) + 1);
    while (q->table[i].room && q->table[i].number != number)
        i = (i + 1) & (q->room - 1);
    return &q->table[i];
}

/* Forgets the numbers whose queues are empty; the table grows if they are less than half. */
static void renew_table(struct queues *q)
{
    struct queues old = *q;
    q->used = 0;
    for (uint32_t i = 0; i < old.room; i++)
        q->used += old.table[i].count > 0;
    if (2 * q->used > old.used)
        q->room *= 2;
    q->table = xcalloc(q->room, sizeof *q->table);
    for (uint32_t i = 0; i < old.room; i++)
        if (old.table[i].count)
            *place_of(q, old.table[i].number) = old.table[i];
        else
            free(old.table[i].ring);
    free(old.table);
}

static struct entry *nth(const struct queue *w, uint32_t i)
{
    return &w->ring[(w->first + i) & (w->room - 1)];
}

static void grow_ring(struct queue *w)
{
    struct queue old = *w;
    w->room = old.room ? 2 * old.room : 8;
    w->ring = xcalloc(w->room, sizeof *w->ring);
    w->first = 0;
    for (uint32_t i = 0; i < old.count; i++)
        w->ring[i] = *nth(&old, i);
    free(old.ring);
}

/* The number's, which is made if there is none. */
static struct queue *made(struct queues *q, uint32_t number)
{
    struct queue *w = place_of(q, number);
    if (!w->room && 4 * (q->used + 1) > 3 * q->room) {
        renew_table(q);
        w = place_of(q, number);
    }
    q->used += !w->room;
    w->number = number;
    if (w->count == w->room)
        grow_ring(w);
    return w;
}

void queues_add(struct queues *q, uint32_t number, int64_t order, void *item)
{
    struct queue *w = made(q, number);
    if (w->count && nth(w, 0)->order > order) {
        w->first = (w->first - 1) & (w->room - 1);
        *nth(w, 0) = (struct entry){order, item};
        w->count++;
        return;
    }
    uint32_t i = w->count++;
    for (; i > 0 && nth(w, i - 1)->order > order; i--)
        *nth(w, i) = *nth(w, i - 1);
    *nth(w, i) = (struct entry){order, item};
}

void queues_remove(struct queues *q, uint32_t number, const void *item)
{
    struct queue *w = place_of(q, number);
    uint32_t i = 0;
    while (i < w->count && nth(w, i)->item != item)
        i++;
    assert(i < w->count);
    for (; i > 0; i--)
        *nth(w, i) = *nth(w, i - 1);
    w->first = (w->first + 1) & (w->room - 1);
    w->count--;
}

void *queues_at(const struct queues *q, uint32_t number, uint32_t i)
{
    const struct queue *w = place_of(q, number);
    return w->room && i < w->count ? nth(w, i)->item : NULL;
}
