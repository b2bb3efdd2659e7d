/* race_places.c - see race_places.h. A program accesses memory from few places, many times: a cache in front
 * tells one again by its site and the innermost frames, without walking all of the stack. Its keys are
 * offsets, so that what it holds does not depend on where the program lies. */
#include "node/self.h"
#include "races/race_places.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

enum { CACHED = 1024, BUCKETS = 1024, FIRST_ROOM = 64 };

struct cached {
    uint64_t key;
    uint32_t number; /* 0: none */
};

struct race_places {
    struct race_place *list; /* list[0] is not used */
    uint32_t count, room;
    uint32_t buckets[BUCKETS];
    struct cached cache[CACHED];
};

struct race_places *race_places_new(void)
{
    struct race_places *t = xcalloc(1, sizeof *t);
    t->list = xcalloc(FIRST_ROOM, sizeof *t->list);
    t->room = FIRST_ROOM, t->count = 1;
    return t;
}

void race_places_free(struct race_places *t)
{
    if (!t)
        return;
    free(t->list);
    free(t);
}

static uint64_t mix(uint64_t h, uint64_t x)
{
    h = (h ^ x) * UINT64_C(0x9e3779b97f4a7c15);
    return h ^ h >> 29;
}

static bool is_same(const struct race_place *a, const struct race_place *b)
{
    return a->site == b->site && a->posted == b->posted && a->depth == b->depth &&
           (a->call == b->call || (a->call && b->call && strcmp(a->call, b->call) == 0)) &&
           memcmp(a->stack, b->stack, a->depth * sizeof *a->stack) == 0;
}

static uint32_t bucket_of(const struct race_place *p)
{
    uint64_t h = mix(mix(p->site, p->posted), p->depth);
    for (uint32_t i = 0; i < p->depth; i++)
        h = mix(h, p->stack[i]);
    return (uint32_t)(h % BUCKETS);
}

/* The number of a place like *p. */
static uint32_t number_of(struct race_places *t, struct race_place *p)
{
    uint32_t *first = &t->buckets[bucket_of(p)];
    for (uint32_t i = *first; i; i = t->list[i].next)
        if (is_same(&t->list[i], p))
            return i;
    if (t->count == RACE_MOST_PLACES)
        return 0;
    if (t->count == t->room)
        t->list = xreallocarray(t->list, t->room *= 2, sizeof *t->list);
    p->next = *first;
    t->list[t->count] = *p;
    return *first = t->count++;
}

/* Steps from a frame to the first whose function the program has called; NULL: there is none. (The frames of
 * the simulator come first.) */
static const uintptr_t *innermost(const struct node *n, const uintptr_t *frame)
{
    while (node_may_be_frame(n, (uintptr_t)frame)) {
        if (frame[1] - (uintptr_t)n->guest.program < n->guest.image_bytes)
            return frame;
        if (frame[0] <= (uintptr_t)frame)
            break;
        frame = (const uintptr_t *)frame[0];
    }
    return NULL;
}

/* A handler's stack ends with the simulator, which has called the handler. */
static void walk(const struct node *n, const uintptr_t *frame, struct race_place *p)
{
    while (node_may_be_frame(n, (uintptr_t)frame) && p->depth < RACE_DEEPEST) {
        uintptr_t offset = frame[1] - (uintptr_t)n->guest.program;
        if (offset >= n->guest.image_bytes)
            break;
        p->stack[p->depth++] = (uint32_t)offset;
        if (frame[0] <= (uintptr_t)frame)
            break;
        frame = (const uintptr_t *)frame[0];
    }
}

/* What tells a place again without walking all of the stack. */
static uint64_t key_of(const struct node *n, uint64_t site, const uintptr_t *frame, uint32_t posted)
{
    enum { LEVELS = 5 }; /* two are in the routines of the program that tell of accesses */
    uint64_t h = mix(site, posted);
    for (int i = 0; i < LEVELS && node_may_be_frame(n, (uintptr_t)frame); i++) {
        uint64_t caller = frame[1] - (uintptr_t)n->guest.program,
                 depth = (uintptr_t)frame - (uintptr_t)n->guest.stack;
        h = mix(h, caller + (depth << 32));
        frame = (const uintptr_t *)frame[0];
    }
    return h;
}

static uint32_t find(struct race_places *t, const struct node *n, struct race_place *p,
                     const uintptr_t *first)
{
    if (first)
        walk(n, first, p);
    return number_of(t, p);
}

uint32_t race_places_here(struct race_places *t, const struct node *n, const void *site, const char *call,
                          uint32_t posted, const void *frame)
{
    const uintptr_t *first = innermost(n, frame);
    uint64_t at = site ? (uintptr_t)site - (uintptr_t)n->guest.program : 0;
    struct race_place p = {.site = (uint32_t)at, .call = site ? NULL : call, .posted = posted};
    if (!site)
        return find(t, n, &p, first);
    uint64_t key = key_of(n, at, first, posted);
    struct cached *c = &t->cache[key % CACHED];
    if (c->key != key || !c->number)
        *c = (struct cached){key, find(t, n, &p, first)};
    return c->number;
}

uint32_t race_places_of_handler(struct race_places *t, const char *call, uint32_t posted)
{
    struct race_place p = t->list[posted];
    p.site = 0, p.call = call, p.posted = posted;
    return number_of(t, &p);
}

const struct race_place *race_places_at(const struct race_places *t, uint32_t number)
{
    return &t->list[number];
}

uint32_t race_places_count(const struct race_places *t)
{
    return t->count;
}
