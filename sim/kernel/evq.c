/* evq.c - see evq.h. A four-ary heap of small values: half the depth of a binary one, children in two cache
 * lines. */
#include "kernel/evq.h"
#include <assert.h>
#include <stdlib.h>

struct event {
    vtime time;
    uint64_t sequence; /* top bit: late */
    evq_fire *fire;
    void *ctx, *arg;
    uint32_t place;
};

struct evq {
    struct event *heap;
    size_t length, room;
    uint64_t sequence;
    vtime now;
};

enum { ARITY = 4 };
#define LATE (UINT64_C(1) << 63)

struct evq *evq_new(void)
{
    return calloc(1, sizeof(struct evq));
}

void evq_free(struct evq *q)
{
    if (!q)
        return;
    free(q->heap);
    free(q);
}

static bool before(const struct event *a, const struct event *b)
{
    if (a->time != b->time)
        return a->time < b->time;
    if (a->place != b->place)
        return a->place < b->place;
    return a->sequence < b->sequence;
}

static void put(struct evq *q, struct event e)
{
    assert(e.time >= q->now);
    if (q->length == q->room) {
        q->room = q->room ? 2 * q->room : 64;
        q->heap = realloc(q->heap, q->room * sizeof *q->heap);
        if (!q->heap)
            abort();
    }
    size_t i = q->length++;
    while (i > 0) {
        size_t parent = (i - 1) / ARITY;
        if (!before(&e, &q->heap[parent]))
            break;
        q->heap[i] = q->heap[parent];
        i = parent;
    }
    q->heap[i] = e;
}

void evq_put(struct evq *q, vtime time, uint32_t place, evq_fire *fire, void *ctx, void *arg)
{
    put(q, (struct event){time, q->sequence++, fire, ctx, arg, place});
}

void evq_put_late(struct evq *q, vtime time, uint32_t place, evq_fire *fire, void *ctx, void *arg)
{
    /* No sequence number is taken: late events must leave no trace in the order of the others. */
    put(q, (struct event){time, LATE, fire, ctx, arg, place});
}

static void remove_first(struct evq *q)
{
    struct event last = q->heap[--q->length];
    size_t i = 0;
    for (;;) {
        size_t first = ARITY * i + 1, end = first + ARITY, least = first;
        if (first >= q->length)
            break;
        if (end > q->length)
            end = q->length;
        for (size_t c = first + 1; c < end; c++)
            if (before(&q->heap[c], &q->heap[least]))
                least = c;
        if (!before(&q->heap[least], &last))
            break;
        q->heap[i] = q->heap[least];
        i = least;
    }
    q->heap[i] = last;
}

vtime evq_next(const struct evq *q)
{
    return q->length ? q->heap[0].time : VT_NEVER;
}

bool evq_late_is_first(const struct evq *q, vtime time, uint32_t place)
{
    struct event e = {.time = time, .place = place, .sequence = LATE};
    return q->length == 0 || before(&e, &q->heap[0]);
}

bool evq_step(struct evq *q)
{
    if (q->length == 0)
        return false;
    struct event e = q->heap[0];
    assert(e.time >= q->now);
    remove_first(q);
    q->now = e.time;
    e.fire(e.ctx, e.arg, e.time);
    return true;
}

size_t evq_length(const struct evq *q)
{
    return q->length;
}
