/* span.h - the address space of nodes: where a node's stack, program and heap lie.
 *
 * Regions of NODE_REGION bytes, at multiples of their size, hold the memory of so many nodes as fit:
 *
 *     region   | span | span | ... | heap -> | guard | heap -> | guard | ...
 *     span     | head | guard | stack <- | program: text, data, bss | guard |
 *
 * The spans are equal, a power of two of bytes each, and so are the heaps. The first span's head has the
 * table of the region's nodes: so a call finds its node from the stack pointer (node_self), wherever in the
 * node's memory the program has its stack, and no state is shared or thread-local. A node's parts are less
 * than 2^30 bytes from each other: programs of the time keep addresses as offsets of 32 bits from their
 * static data. Programs whose long has 32 bits get regions below 2^32, as long as there are any.
 *
 * What a small program uses lies within some pages on both sides of its program's start, whose entries in the
 * page tables are neighbours, and those of the levels above are its neighbour spans', too: the smaller the
 * spans, the less does a switch between thousands of nodes cost. So heaps, which need room for all of a
 * node's memory, are not in there.
 *
 * Guards are pages that nobody may use: whoever runs over the end of a stack, of static data or of a heap is
 * stopped there. A region is one mapping of the host, without physical memory until it is touched. Each
 * node's text is one, too, the file's pages. On kernels that have guards without mappings
 * (MADV_GUARD_INSTALL, Linux 6.13) that is all; on others each guard is one, and divides another. A process
 * may have vm.max_map_count of them, 65,530 if nobody has changed that. So on older kernels some 10,000 nodes
 * have all guards and share the text; 15,000 have copies of it instead; of 31,000 only the stacks are
 * guarded, and of more, nothing is.
 */
#ifndef NODE_SPAN_H
#define NODE_SPAN_H
#include <stdbool.h>
#include <stddef.h>
#include "node/node.h"

/* Finds n a span for a program of so many bytes (page rounded) and a heap: sets region, span, stack, program
 * and heap_start; memory there is zero and may be written to. long32: the program's long has 32 bits. False
 * when this computer has no address space left for it. */
bool span_take(struct node *n, size_t program_bytes, bool long32);
/* Gives it back. */
void span_release(struct node *n);
#endif
