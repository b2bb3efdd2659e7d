/* evq.c - see evq.h. A four-ary heap: half the depth of a binary one. Its entries are 24 bytes, so that four children
 * are two cache lines; what is to happen lies beside, and does not move. An event's place in the order is one number of
 * 128 bits, compared without branches:  time (64) | place (20) | late (1) | sequence (43).
 * bench/speed/NOTES.md has it beside other structures. */
#include "kernel/evq.h"
#include <assert.h>
#include <stdlib.h>

struct action {
    evq_fire *fire;
    void *ctx, *arg;
};

struct entry {
    vtime time;
    uint64_t rank;
    uint32_t action; /* its number in evq.actions */
};

struct evq {
    struct entry *heap;
    size_t length, room;
    struct action *actions;
    uint32_t *unused; /* unused[length .. room - 1]: numbers of actions not in use */
    uint64_t sequence;
    vtime now;
};

enum { ARITY = 4, SEQUENCE_BITS = 43, PLACE_BITS = 20 };
#define LATE (UINT64_C(1) << SEQUENCE_BITS)

struct evq *evq_new(void)
{
    return calloc(1, sizeof(struct evq));
}

void evq_free(struct evq *q)
{
    if (!q)
        return;
    free(q->heap);
    free(q->actions);
    free(q->unused);
    free(q);
}

static uint64_t rank_of(uint32_t place, uint64_t late_and_sequence)
{
    assert(place < UINT32_C(1) << PLACE_BITS);
    return (uint64_t)place << (SEQUENCE_BITS + 1) | late_and_sequence;
}

static inline bool before(const struct entry *a, const struct entry *b)
{
    return ((unsigned __int128)a->time << 64 | a->rank) < ((unsigned __int128)b->time << 64 | b->rank);
}

static void *resized(void *p, size_t bytes)
{
    p = realloc(p, bytes);
    if (!p)
        abort();
    return p;
}

static void make_room(struct evq *q)
{
    size_t room = q->room ? 2 * q->room : 64;
    q->heap = resized(q->heap, room * sizeof *q->heap);
    q->actions = resized(q->actions, room * sizeof *q->actions);
    q->unused = resized(q->unused, room * sizeof *q->unused);
    for (size_t i = q->room; i < room; i++)
        q->unused[i] = (uint32_t)i;
    q->room = room;
}

static void put(struct evq *q, vtime time, uint64_t rank, struct action what)
{
    assert(time >= q->now);
    if (q->length == q->room)
        make_room(q);
    struct entry e = {time, rank, q->unused[q->length]};
    q->actions[e.action] = what;
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
    assert(q->sequence < LATE);
    put(q, time, rank_of(place, q->sequence++), (struct action){fire, ctx, arg});
}

void evq_put_late(struct evq *q, vtime time, uint32_t place, evq_fire *fire, void *ctx, void *arg)
{
    /* No sequence number is taken: late events must leave no trace in the order of the others. */
    put(q, time, rank_of(place, LATE), (struct action){fire, ctx, arg});
}

/* The first of the four children from `first` on, all of which exist: chosen by moves, not by jumps. */
static inline size_t least_of_four(const struct entry *heap, size_t first)
{
    size_t a = first + before(&heap[first + 1], &heap[first]);
    size_t b = first + 2 + before(&heap[first + 3], &heap[first + 2]);
    return before(&heap[b], &heap[a]) ? b : a;
}

static size_t least_child(const struct evq *q, size_t first)
{
    if (first + ARITY <= q->length)
        return least_of_four(q->heap, first);
    size_t least = first;
    for (size_t c = first + 1; c < q->length; c++)
        if (before(&q->heap[c], &q->heap[least]))
            least = c;
    return least;
}

static void remove_first(struct evq *q)
{
    q->unused[--q->length] = q->heap[0].action;
    struct entry last = q->heap[q->length];
    size_t i = 0;
    for (size_t first; (first = ARITY * i + 1) < q->length;) {
        size_t least = least_child(q, first);
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

uint32_t evq_next_place(const struct evq *q)
{
    return q->length ? (uint32_t)(q->heap[0].rank >> (SEQUENCE_BITS + 1)) : UINT32_MAX;
}

bool evq_late_is_first(const struct evq *q, vtime time, uint32_t place)
{
    struct entry e = {.time = time, .rank = rank_of(place, LATE)};
    return q->length == 0 || before(&e, &q->heap[0]);
}

bool evq_step(struct evq *q)
{
    if (q->length == 0)
        return false;
    vtime now = q->heap[0].time;
    struct action what = q->actions[q->heap[0].action];
    assert(now >= q->now);
    remove_first(q);
    q->now = now;
    what.fire(what.ctx, what.arg, now);
    return true;
}

void *evq_coming(const struct evq *q, unsigned after, evq_fire *fire)
{
    assert(after < 2);
    if (q->length <= after)
        return NULL;
    const struct action *a = &q->actions[q->heap[after ? least_child(q, 1) : 0].action];
    return a->fire == fire ? a->ctx : NULL;
}

size_t evq_length(const struct evq *q)
{
    return q->length;
}
