/* asan_stacks.h - the stacks that allocated and freed blocks of the heap: stacks of calls, each kept once. */
#ifndef ASAN_ASAN_STACKS_H
#define ASAN_ASAN_STACKS_H
#include "node/node.h"

enum { ASAN_DEEPEST = 12 };

struct asan_stack {
    uint32_t next; /* of the same bucket; 0: none */
    uint32_t depth;
    uint32_t returns[ASAN_DEEPEST]; /* innermost first, from the program's beginning */
};

struct asan_stacks;

struct asan_stacks *asan_stacks_new(void);
void asan_stacks_free(struct asan_stacks *t);
/* The number of the stack of the program's calls from a frame upwards; 0: there are too many stacks. */
uint32_t asan_stacks_here(struct asan_stacks *t, const struct node *n, const void *frame);
/* NULL for 0. */
const struct asan_stack *asan_stacks_at(const struct asan_stacks *t, uint32_t number);
#endif
