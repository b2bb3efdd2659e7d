/* evq.c - see evq.h. No event is put before the present, so an event's slot is found without a look at
 * others: the time is read in digits of 6 bits; the first digit, from the top, in which it differs from the
 * present time chooses the level, and what that digit is, the slot. Such a queue is called a radix heap
 * (Ahuja, Mehlhorn, Orlin, Tarjan, JACM 37, 1990).
 *
 *      the present time   0 0 3 17 60 41  2
 *      an event's         0 0 3 22  5 11  9    lies in slot 22 of level 3 (digits count from the right)
 *
 * The first slot of the lowest level that has any holds the next events. When the present is over, they are
 * spread over lower levels: the first of them is the new present, from which the others differ in lower
 * digits. So an event moves three or four times with 100,000 pending, and most often not at all: nodes that
 * do the same put events of one time in the order of their addresses, and such a slot is the new present as
 * it lies. bench/speed/NOTES.md compares this queue with others.
 *
 * The events of the present time that came in order are a list, the run. Lists are made of chunks, for memory
 * in order of use. Beside the lists is a heap, for what came out of order in the present, and for a few
 * events of any time: with as few as that, there is nothing else.
 */
#include "kernel/evq.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/prefetch.h"
#include "kernel/arena.h"
#include "kernel/xalloc.h"

/* An event's key is one number of 128 bits, compared without branches: time (64) | address (20) | late (1)
 * | ordinary (1) | sequence (42), or for those that are not ordinary: source (20) | number (22). */
struct key {
    vtime time;
    uint64_t rank;
};

struct action {
    evq_fire *fire;
    void *ctx, *arg;
};

struct event {
    struct key key;
    struct action what;
};

enum { SEQUENCE_BITS = 43, PLACE_BITS = 20 };
enum { DIGIT_BITS = 6, DIGITS = 1 << DIGIT_BITS, LEVELS = (64 + DIGIT_BITS - 1) / DIGIT_BITS };
enum { CHUNK = 25, FEW = 4 }; /* of a chunk: as many as fit into 1 KB */
enum { AHEAD = 4 };           /* load_ahead */
#define LATE (UINT64_C(1) << SEQUENCE_BITS)
#define ORDINARY (LATE >> 1)

struct chunk {
    struct chunk *next;
    struct event events[CHUNK];
};

/* Events in the order they were put. There is at least one; all chunks but the last are full. */
struct list {
    struct chunk *first, *last;
    struct event *end; /* in the last chunk: behind the last event */
};

struct slot {
    struct list list;
    const struct event *least; /* NULL: the list is in order, the first is the least */
};

struct evq {
    vtime now;     /* of the latest event taken out */
    vtime present; /* not after now; where the slots' times are reckoned from */
    uint64_t sequence, late_sequence;
    struct event *next; /* the first of the run; NULL: it is empty, and `run` means nothing */
    struct list run;
    struct event *heap;
    size_t heap_length, heap_room;
    uint32_t levels;         /* bit L: filled[L] is not 0 */
    uint64_t filled[LEVELS]; /* bit D: slot D has events */
    struct slot slots[LEVELS][DIGITS];
    struct arena chunks;
};

/* For more in the heap than now, and for FEW at least. */
static void make_room(struct evq *q)
{
    q->heap_room = 2 * q->heap_room + 64;
    q->heap = xreallocarray(q->heap, q->heap_room, sizeof *q->heap);
}

struct evq *evq_new(void)
{
    struct evq *q = xcalloc(1, sizeof *q);
    q->chunks.bytes = sizeof(struct chunk);
    make_room(q);
    return q;
}

void evq_free(struct evq *q)
{
    if (!q)
        return;
    arena_free(&q->chunks);
    free(q->heap);
    free(q);
}

static uint64_t rank_of(uint32_t address, uint64_t late_and_sequence)
{
    assert(address < UINT32_C(1) << PLACE_BITS);
    return (uint64_t)address << (SEQUENCE_BITS + 1) | late_and_sequence;
}

static inline struct instant moment(struct key k)
{
    return (struct instant){k.time, (uint32_t)(k.rank >> (SEQUENCE_BITS + 1))};
}

static inline bool before(struct key a, struct key b)
{
    return ((unsigned __int128)a.time << 64 | a.rank) < ((unsigned __int128)b.time << 64 | b.rank);
}

/* The earlier of two, of which there may be none. */
static inline const struct event *earlier(const struct event *a, const struct event *b)
{
    return !b || (a && before(a->key, b->key)) ? a : b;
}

/* --- lists --- */

static __attribute__((noinline)) struct chunk *new_chunk(struct evq *q)
{
    struct chunk *c = arena_take(&q->chunks);
    c->next = NULL;
    return c;
}

/* Room for the first event of a list. */
static struct event *begin(struct evq *q, struct list *l)
{
    struct chunk *c = new_chunk(q);
    *l = (struct list){c, c, c->events + 1};
    return c->events;
}

/* Room for one more. */
static inline struct event *append(struct evq *q, struct list *l)
{
    if (l->end == l->last->events + CHUNK) {
        l->last = l->last->next = new_chunk(q);
        l->end = l->last->events;
    }
    return l->end++;
}

/* The event after e, which is in the list's first chunk. NULL: e is the last. */
static inline struct event *following(const struct list *l, struct event *e)
{
    if (++e == l->end)
        return NULL;
    return e == l->first->events + CHUNK ? l->first->next->events : e;
}

/* --- the heap --- */

/* There is room. */
static inline struct event *add_few(struct evq *q, struct key k)
{
    size_t i = q->heap_length++;
    for (; i > 0 && before(k, q->heap[(i - 1) / 2].key); i = (i - 1) / 2)
        q->heap[i] = q->heap[(i - 1) / 2];
    return &q->heap[i];
}

static struct event *add_heap(struct evq *q, struct key k)
{
    if (q->heap_length == q->heap_room)
        make_room(q);
    return add_few(q, k);
}

static struct action take_heap(struct evq *q)
{
    struct action what = q->heap[0].what;
    const struct event *last = &q->heap[--q->heap_length];
    size_t i = 0;
    for (size_t child; (child = 2 * i + 1) < q->heap_length; i = child) {
        if (child + 1 < q->heap_length && before(q->heap[child + 1].key, q->heap[child].key))
            child++;
        if (!before(q->heap[child].key, last->key))
            break;
        q->heap[i] = q->heap[child];
    }
    if (q->heap_length)
        q->heap[i] = *last;
    return what;
}

/* --- the present's run --- */

static struct event *add_present(struct evq *q, struct key k)
{
    if (!q->next)
        return q->next = begin(q, &q->run);
    return before(k, q->run.end[-1].key) ? add_heap(q, k) : append(q, &q->run);
}

/* The event so many after the next of the run, if that is not too far away. NULL: unknown, or there is none.
 */
static inline const struct event *coming(const struct evq *q, unsigned after)
{
    const struct chunk *c = q->run.first;
    const struct event *e = q->next + after, *end = c->events + CHUNK;
    if (e >= end && c != q->run.last)
        c = c->next, e = c->events + (e - end);
    return c != q->run.last || e < q->run.end ? e : NULL;
}

static inline __attribute__((always_inline)) void load_ahead(const struct evq *q)
{
    const struct event *e = coming(q, AHEAD);
    if (!e)
        return;
    prefetch_block(e->what.ctx);
    prefetch_pair(e->what.arg);
}

static inline struct action take_run(struct evq *q)
{
    struct event *e = q->next;
    struct action what = e->what;
    load_ahead(q);
    q->next = following(&q->run, e);
    if (q->next != e + 1) {
        struct chunk *c = q->run.first;
        q->run.first = c->next;
        arena_give(&q->chunks, c);
    }
    return what;
}

/* --- the future's slots --- */

static __attribute__((noinline)) struct event *add_unordered(struct evq *q, struct slot *s, struct key k)
{
    struct event *e = append(q, &s->list);
    if (!s->least)
        s->least = s->list.first->events;
    if (before(k, s->least->key))
        s->least = e;
    return e;
}

/* Where a time that is not the present lies. */
struct place {
    unsigned level, digit;
};

static inline struct place place_of(const struct evq *q, vtime time)
{
    unsigned level = (63 - (unsigned)__builtin_clzll(time ^ q->present)) / DIGIT_BITS;
    return (struct place){level, time >> DIGIT_BITS * level & (DIGITS - 1)};
}

static struct event *add_future(struct evq *q, struct key k)
{
    struct place p = place_of(q, k.time);
    struct slot *s = &q->slots[p.level][p.digit];
    if (!(q->filled[p.level] >> p.digit & 1)) {
        q->filled[p.level] |= UINT64_C(1) << p.digit;
        q->levels |= UINT32_C(1) << p.level;
        s->least = NULL;
        return begin(q, &s->list);
    }
    return before(k, s->list.end[-1].key) ? add_unordered(q, s, k) : append(q, &s->list);
}

static inline const struct event *least(const struct slot *s)
{
    return s->least ? s->least : s->list.first->events;
}

/* The slot of the next events. NULL: there is none. */
static inline const struct slot *coming_slot(const struct evq *q)
{
    if (!q->levels)
        return NULL;
    int level = __builtin_ctz(q->levels);
    return &q->slots[level][__builtin_ctzll(q->filled[level])];
}

static inline void clear_next_slot(struct evq *q)
{
    int level = __builtin_ctz(q->levels);
    q->filled[level] &= q->filled[level] - 1;
    if (!q->filled[level])
        q->levels &= q->levels - 1;
}

/* Room for an event in the list that is right for its time. */
static inline struct event *add(struct evq *q, struct key k)
{
    return k.time == q->present ? add_present(q, k) : add_future(q, k);
}

static void spread(struct evq *q, struct list l)
{
    for (struct chunk *c = l.first, *next; c; c = next) {
        const struct event *end = c == l.last ? l.end : c->events + CHUNK;
        for (const struct event *e = c->events; e < end; e++)
            *add(q, e->key) = *e;
        next = c->next;
        arena_give(&q->chunks, c);
    }
}

/* The present is over, the time of the next events begins. False: there are none. */
static inline bool advance(struct evq *q)
{
    const struct slot *s = coming_slot(q);
    if (!s)
        return false;
    clear_next_slot(q);
    q->present = least(s)->key.time;
    if (!s->least && s->list.end[-1].key.time == q->present) {
        q->run = s->list;
        q->next = q->run.first->events;
    } else {
        spread(q, s->list);
    }
    return true;
}

/* --- what evq.h offers --- */

/* Room for an event that comes last in its list, if there is any without a new chunk. */
static inline struct event *add_last(struct evq *q, struct key k)
{
    struct list *l = &q->run;
    if (k.time != q->present) {
        struct place p = place_of(q, k.time);
        l = q->filled[p.level] >> p.digit & 1 ? &q->slots[p.level][p.digit].list : NULL;
    } else if (!q->next) {
        l = NULL;
    }
    return l && l->end != l->last->events + CHUNK && !before(k, l->end[-1].key) ? l->end++ : NULL;
}

static __attribute__((noinline)) void put_slowly(struct evq *q, struct key k, evq_fire *fire, void *ctx,
                                                 void *arg)
{
    *add(q, k) = (struct event){k, {fire, ctx, arg}};
}

/* (What calls nothing comes first: then it saves no registers.) */
static inline __attribute__((always_inline)) void put(struct evq *q, struct key k, struct action what)
{
    assert(k.time >= q->now);
    struct event *e = q->heap_length < FEW ? add_few(q, k) : add_last(q, k);
    if (e)
        *e = (struct event){k, what};
    else
        put_slowly(q, k, what.fire, what.ctx, what.arg);
}

void evq_put(struct evq *q, vtime time, uint32_t address, evq_fire *fire, void *ctx, void *arg)
{
    assert(q->sequence < ORDINARY);
    put(q, (struct key){time, rank_of(address, ORDINARY | q->sequence++)}, (struct action){fire, ctx, arg});
}

void evq_put_sent(struct evq *q, vtime time, uint32_t address, struct evq_sender by, evq_fire *fire,
                  void *ctx, void *arg)
{
    uint64_t number = by.number & ((UINT64_C(1) << EVQ_NUMBER_BITS) - 1);
    put(q, (struct key){time, rank_of(address, (uint64_t)by.address << EVQ_NUMBER_BITS | number)},
        (struct action){fire, ctx, arg});
}

void evq_put_late(struct evq *q, vtime time, uint32_t address, evq_fire *fire, void *ctx, void *arg)
{
    /* They have a sequence of their own: late events must leave no trace in the order of the others. */
    assert(q->late_sequence < LATE);
    put(q, (struct key){time, rank_of(address, LATE | q->late_sequence++)}, (struct action){fire, ctx, arg});
}

/* The first of those that are not in the heap. NULL: there is none. */
static inline const struct event *first_of_lists(const struct evq *q)
{
    if (q->next)
        return q->next;
    const struct slot *s = coming_slot(q);
    return s ? least(s) : NULL;
}

static inline const struct event *in_heap(const struct evq *q, size_t i)
{
    return i < q->heap_length ? &q->heap[i] : NULL;
}

static inline const struct event *first(const struct evq *q)
{
    return earlier(in_heap(q, 0), first_of_lists(q));
}

vtime evq_next(const struct evq *q)
{
    const struct event *e = first(q);
    return e ? e->key.time : VT_NEVER;
}

uint32_t evq_next_address(const struct evq *q)
{
    const struct event *e = first(q);
    return e ? moment(e->key).address : UINT32_MAX;
}

bool evq_late_is_first(const struct evq *q, vtime time, uint32_t address)
{
    const struct key k = {time, rank_of(address, LATE | q->late_sequence)};
    const struct event *list = first_of_lists(q);
    return !(list && before(list->key, k)) && !(q->heap_length && before(q->heap[0].key, k));
}

static inline bool heap_is_first(const struct evq *q)
{
    const struct event *list = first_of_lists(q);
    return q->heap_length && (!list || before(q->heap[0].key, list->key));
}

bool evq_step(struct evq *q, struct instant *present, struct instant *reached)
{
    if (!q->next && !heap_is_first(q) && !advance(q))
        return false;
    struct action what;
    if (heap_is_first(q)) {
        *present = moment(q->heap[0].key);
        what = take_heap(q);
    } else {
        *present = moment(q->next->key);
        what = take_run(q);
    }
    *reached = instant_later(*present, *reached);
    q->now = present->time;
    what.fire(what.ctx, what.arg, q->now);
    return true;
}

void *evq_coming(const struct evq *q, unsigned after, evq_fire **fire)
{
    assert(after < CHUNK);
    const struct event *e = q->next ? coming(q, after) : NULL;
    *fire = e ? e->what.fire : NULL;
    return e ? e->what.ctx : NULL;
}
