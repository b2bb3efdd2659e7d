/* span.h - the address space of nodes: where a node's stack, program and heap lie.
 *
 * Regions of NODE_REGION bytes, at multiples of their size, are divided into equal spans, a power of two each, one for each node:
 *
 *     region   | span | span | span | ...                         as many as fit
 *     span     | head | guard | stack <- | program: text, data, bss |
 *     heaps    | heap -> | heap -> | ...                          of the nodes of a region, elsewhere
 *
 * A region's first head has the table of its nodes: so a call finds its node from the stack pointer (node_self), and no
 * state is shared or thread-local. What a small program uses lies within some pages on both sides of its program's start,
 * whose entries in the page tables are neighbours, and those of the levels above are its neighbour spans', too: the smaller the
 * spans, the less does a switch between thousands of nodes cost. So heaps, which need room for all of a node's memory, are not
 * in there.
 *
 * A region is one mapping of the host (vm.max_map_count allows 65,530), and its heaps are another, without physical memory
 * until it is touched. Each node's text is one, too, the file's pages, so that a span takes two. Where that would be too many
 * the nodes have copies of the text in their spans. Guards are none where the kernel can do without (MADV_GUARD_INSTALL, Linux 6.13), else they
 * are one, which divides another; with copies of the text and too many nodes for that, there are no guards.
 */
#ifndef NODE_SPAN_H
#define NODE_SPAN_H
#include <stdbool.h>
#include <stddef.h>
#include "node/node.h"

/* Finds n a span for a program of so many bytes (page rounded) and a heap: sets region, span, stack, program and heap_start;
 * memory there is zero and may be written to. False when this computer has no address space left for it. */
bool span_take(struct node *n, size_t program_bytes);
/* Gives it back. */
void span_release(struct node *n);
#endif
