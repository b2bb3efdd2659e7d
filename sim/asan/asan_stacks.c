/* asan_stacks.c - see asan_stacks.h. */
#include "asan/asan_stacks.h"
#include <stdlib.h>
#include <string.h>
#include "guest/backtrace.h"
#include "kernel/xalloc.h"

enum { BUCKETS = 1024, MOST_STACKS = 1 << 18, MOST_FRAMES = 32 };

struct asan_stacks {
    struct asan_stack *list; /* 0 is no stack */
    uint32_t count, room;
    uint32_t buckets[BUCKETS];
};

struct asan_stacks *asan_stacks_new(void)
{
    struct asan_stacks *t = xcalloc(1, sizeof *t);
    t->count = 1, t->room = 64;
    t->list = xcalloc(t->room, sizeof *t->list);
    return t;
}

void asan_stacks_free(struct asan_stacks *t)
{
    if (t)
        free(t->list);
    free(t);
}

/* The frames of the simulator come first, and are left out. */
static void walk(const struct node *n, const void *frame, struct asan_stack *s)
{
    uintptr_t returns[MOST_FRAMES];
    int depth = backtrace_walk(n, (uintptr_t)frame, returns, MOST_FRAMES);
    for (int i = 0; i < depth && s->depth < ASAN_DEEPEST; i++)
        if (backtrace_in_program(n, returns[i]))
            s->returns[s->depth++] = (uint32_t)(returns[i] - (uintptr_t)n->guest.program);
}

static uint32_t bucket_of(const struct asan_stack *s)
{
    uint64_t h = s->depth;
    for (uint32_t i = 0; i < s->depth; i++)
        h = (h ^ s->returns[i]) * UINT64_C(0x9e3779b97f4a7c15);
    return (uint32_t)(h >> 40) % BUCKETS;
}

uint32_t asan_stacks_here(struct asan_stacks *t, const struct node *n, const void *frame)
{
    struct asan_stack s = {0};
    walk(n, frame, &s);
    uint32_t *first = &t->buckets[bucket_of(&s)];
    for (uint32_t i = *first; i; i = t->list[i].next)
        if (t->list[i].depth == s.depth && !memcmp(t->list[i].returns, s.returns, sizeof s.returns))
            return i;
    if (t->count == MOST_STACKS)
        return 0;
    if (t->count == t->room)
        t->list = xreallocarray(t->list, t->room *= 2, sizeof *t->list);
    s.next = *first;
    t->list[t->count] = s;
    return *first = t->count++;
}

const struct asan_stack *asan_stacks_at(const struct asan_stacks *t, uint32_t number)
{
    return number ? &t->list[number] : NULL;
}
