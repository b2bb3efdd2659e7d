/* heap.h - malloc for one node: blocks inside the node's span, bounded by the node's memory.
 * Deterministic (addresses depend on the program's calls only). Memory given back at the top lowers what is
 * counted. */
#ifndef NODE_HEAP_H
#define NODE_HEAP_H
#include <stdbool.h>
#include <stddef.h>

struct node_heap;

/* A heap at base, at most limit bytes of address space (that is there already, and zero). room(ctx, bytes)
 * tells whether the heap may grow to that many bytes; grown(ctx, used) is called after it did or shrank. */
struct node_heap *node_heap_new(void *base, size_t limit, int (*room)(void *ctx, size_t bytes),
                                void (*grown)(void *ctx, size_t used), void *ctx);
void node_heap_free(struct node_heap *h);                 /* the address space stays with the node's span */
void *node_heap_alloc(struct node_heap *h, size_t bytes); /* 16-byte aligned; NULL when there is no room */
/* The same at a multiple of align, a power of two. */
void *node_heap_alloc_aligned(struct node_heap *h, size_t align, size_t bytes);
/* NULL with p unchanged when there is no room or p is not a block of this heap. */
void *node_heap_resize(struct node_heap *h, void *p, size_t bytes);
bool node_heap_owns(const struct node_heap *h, const void *p); /* p is a block in use, and undamaged */
int node_heap_release(struct node_heap *h, void *p); /* 0, or -1 when p is not a block of this heap */
/* Looks for a block that was written past its end, or before its start: *block is what the program has of it,
 * NULL if there is none. Returns the bytes that the program had asked for there. */
size_t node_heap_check(const struct node_heap *h, const void **block);
size_t node_heap_used(const struct node_heap *h); /* bytes up to the end of the highest block in use */
#endif
