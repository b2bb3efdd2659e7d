/* heap.h - malloc for one node: blocks inside the node's span, bounded by the node's memory. Deterministic:
 * addresses depend on the program's calls only. Memory freed at the top no longer counts as used. */
#ifndef GUEST_HEAP_H
#define GUEST_HEAP_H
#include <stdbool.h>
#include <stddef.h>

struct node_heap;

/* Makes a heap at base, which is 16-byte aligned, of at most limit bytes of address space. That space is
 * mapped already, and zero. room(ctx, bytes) tells whether the heap may grow to that many bytes; grown(ctx,
 * used) is called after it grew or shrank. */
struct node_heap *node_heap_new(void *base, size_t limit, int (*room)(void *ctx, size_t bytes),
                                void (*grown)(void *ctx, size_t used), void *ctx);
void node_heap_free(struct node_heap *h);                 /* the address space belongs to the node's span */
void *node_heap_alloc(struct node_heap *h, size_t bytes); /* 16-byte aligned; NULL if there is no room */
/* As node_heap_alloc(), at a multiple of align, a power of two. */
void *node_heap_alloc_aligned(struct node_heap *h, size_t align, size_t bytes);
/* Returns NULL and leaves p unchanged if there is no room or p is not a block of this heap. */
void *node_heap_resize(struct node_heap *h, void *p, size_t bytes);
bool node_heap_owns(const struct node_heap *h, const void *p); /* is p an undamaged block in use? */
/* The bytes that it was asked for; 0: p is no such block. */
size_t node_heap_bytes(const struct node_heap *h, const void *p);
int node_heap_release(struct node_heap *h, void *p); /* 0, or -1 if p is no such block */
/* Where UNIX would say that the program's memory ends, for sbrk(): what it gets by node_heap_move_break()
 * begins here. It rises with blocks that are allocated above all others, too. */
void *node_heap_break(const struct node_heap *h);
/* Moves the break by so many bytes; new ones are 0. Returns false and changes nothing if there is no room, or
 * if what lies below the break is not all the break's own. */
bool node_heap_move_break(struct node_heap *h, ptrdiff_t by);
/* Looks for a block that was written past its end, or before its start. Sets *block to the address that the
 * program has of it, NULL if there is none, and returns the bytes that the program had asked for there. */
size_t node_heap_check(const struct node_heap *h, const void **block);
/* The bytes of all blocks in use, with what the heap needs for each; and the number of free blocks. */
size_t node_heap_in_use(const struct node_heap *h, size_t *free_blocks);
size_t node_heap_used(const struct node_heap *h); /* bytes up to the end of the highest used block */
#endif
