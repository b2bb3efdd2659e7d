/* evq.c - the event queue of kernel/evq.h as a binary heap: the order is in before(), and nowhere else. */
#include "kernel/evq.h"
#include "kernel/xalloc.h"
#include <assert.h>
#include <stdlib.h>

struct event {
    vtime time;
    uint32_t address;
    bool late, sent;
    uint64_t sender, sequence; /* sender: of those that programs have sent, else 0 */
    evq_fire *fire;
    void *ctx, *arg;
};

struct evq {
    struct event *heap; /* no event is before heap[(i - 1) / 2], its parent */
    size_t length, room;
    uint64_t sequence;
    vtime now; /* of the latest event taken out: none is put before it */
};

struct evq *evq_new(void)
{
    return calloc(1, sizeof(struct evq));
}

void evq_free(struct evq *q)
{
    free(q ? q->heap : NULL);
    free(q);
}

/* Time, address, those that are not late, those that were sent, by sender and his number; the others as they
 * were put. */
static bool before(const struct event *a, const struct event *b)
{
    if (a->time != b->time)
        return a->time < b->time;
    if (a->address != b->address)
        return a->address < b->address;
    if (a->late != b->late)
        return b->late;
    if (a->sent != b->sent)
        return a->sent;
    return a->sender != b->sender ? a->sender < b->sender : a->sequence < b->sequence;
}

static void swap(struct event *a, struct event *b)
{
    struct event e = *a;
    *a = *b;
    *b = e;
}

static void put(struct evq *q, struct event e)
{
    assert(e.time >= q->now);
    if (q->length == q->room) {
        q->room = 2 * q->room + 64;
        q->heap = xreallocarray(q->heap, q->room, sizeof *q->heap);
    }
    size_t i = q->length++;
    q->heap[i] = e;
    for (; i > 0 && before(&q->heap[i], &q->heap[(i - 1) / 2]); i = (i - 1) / 2)
        swap(&q->heap[i], &q->heap[(i - 1) / 2]);
}

static struct event take(struct evq *q)
{
    struct event first = q->heap[0];
    q->heap[0] = q->heap[--q->length];
    for (size_t i = 0, child; (child = 2 * i + 1) < q->length; i = child) {
        if (child + 1 < q->length && before(&q->heap[child + 1], &q->heap[child]))
            child++;
        if (!before(&q->heap[child], &q->heap[i]))
            break;
        swap(&q->heap[child], &q->heap[i]);
    }
    return first;
}

void evq_put(struct evq *q, vtime time, uint32_t address, evq_fire *fire, void *ctx, void *arg)
{
    put(q, (struct event){time, address, .sequence = q->sequence++, .fire = fire, .ctx = ctx, .arg = arg});
}

void evq_put_late(struct evq *q, vtime time, uint32_t address, evq_fire *fire, void *ctx, void *arg)
{
    put(q, (struct event){time, address, .late = true, .sequence = q->sequence++, .fire = fire, .ctx = ctx,
                          .arg = arg});
}

void evq_put_sent(struct evq *q, vtime time, uint32_t address, struct evq_sender by, evq_fire *fire,
                  void *ctx, void *arg)
{
    uint64_t number = by.number & ((UINT64_C(1) << EVQ_NUMBER_BITS) - 1);
    put(q, (struct event){time, address, .sent = true, .sender = by.address, .sequence = number, fire, ctx,
                          arg});
}

vtime evq_next(const struct evq *q)
{
    return q->length ? q->heap[0].time : VT_NEVER;
}

bool evq_step(struct evq *q, struct instant *present, struct instant *reached)
{
    if (!q->length)
        return false;
    struct event e = take(q);
    *present = (struct instant){e.time, e.address};
    *reached = instant_later(*present, *reached);
    q->now = e.time;
    e.fire(e.ctx, e.arg, e.time);
    return true;
}
