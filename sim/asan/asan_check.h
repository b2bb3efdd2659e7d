/* asan_check.h - the checker of accesses to memory: of nodes whose programs were built with nxcc --asan. How
 * the nodes tell of what they do is in os/asan_hooks.h. */
#ifndef ASAN_ASAN_CHECK_H
#define ASAN_ASAN_CHECK_H
#include "node/system.h"

struct asan;
struct node_asan;

/* What the shadows of a machine's nodes share. */
struct asan *asan_new(void);
void asan_free(struct asan *a);
/* Makes the checker of a node whose program has been mapped, for node.asan. NULL: this computer has no
 * address space left. */
struct node_asan *asan_begin(struct asan *a, struct node *n);
/* The addresses that the node's heap is to have, as many as n->heap_start has. */
void *asan_heap_base(const struct node_asan *a);
/* The program is gone, and with it node.asan. */
void asan_end(struct node *n);
#endif
