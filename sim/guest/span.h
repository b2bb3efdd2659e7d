/* span.h - the address space of nodes: where a node's stack, program and heap lie.
 *
 * Regions of NODE_REGION bytes, at equal distances, hold the memory of as many nodes as fit:
 *
 *     region   | span | span | ... | heap -> | guard | heap -> | guard | ...
 *     span     | head | guard | system's stack <- | guard | stack <- | arguments |
 *              | program: text, data, bss | guard |
 *
 * All spans of a region have one size, a power of two; all heaps have one size, too. The head of the first
 * span holds the table of the region's nodes. So a call finds its node from the stack pointer (node_self),
 * and no state is shared or thread-local. A node's parts are less than 2^30 bytes apart, since programs of
 * the time keep addresses as offsets of 32 bits from their static data; only a node of more memory than that
 * has a region that is longer, by a whole number of times. Programs whose long has 32 bits get
 * regions below 2^32 as long as there are any, the lowest first: an address below 2^31 is right even when the
 * program keeps it in an int.
 *
 * A small program uses only some pages on both sides of its start, so its entries of the page tables lie
 * together; in the levels above, entries are shared with the neighbour spans. The smaller the spans, the
 * cheaper is a switch among thousands of nodes. Heaps need address space for all of a node's memory, so
 * they lie outside of the spans.
 *
 * Guards are pages that nobody may use: a program that runs over the end of a stack, of static data or of
 * a heap is stopped there. A region is one mapping of the host, without physical memory until it is
 * touched; each node's text is one more, of the file's pages. Kernels with guards that are no mappings
 * (MADV_GUARD_INSTALL, Linux 6.13) need no others. On older kernels each guard is a mapping, and divides
 * another in two; a process may have vm.max_map_count mappings, by default 65,530. So on older kernels
 * some 7,900 nodes have all guards and map the text; 10,500 have all guards and no mapping of the text; of
 * 15,800, only the stacks are guarded; of more, nothing is. Where texts have no mappings (light guards: above
 * 31,000 nodes), a region's spans are one mapping of a file that has them all (span_texts.h); programs other
 * than the first are copied. */
#ifndef GUEST_SPAN_H
#define GUEST_SPAN_H
#include <stdbool.h>
#include <stddef.h>
#include "node/node.h"

/* Addresses where programs lie, from multiples of 2^32 to such; unless this computer uses the usual ones for
 * something else. */
enum { SPAN_USUAL, SPAN_LOW };
extern const struct span_range {
    uintptr_t from, to;
} SPAN_RANGES[2];

/* Gives n, which has none, a span and a heap for a program of so many bytes (page rounded): sets region,
 * span, both stacks, program and heap_start. The memory there is zero and may be written to. above_bytes:
 * so many are left free behind the stack's end, stack + stack_bytes, a multiple of a cache line. long32:
 * the program's long has 32 bits. asan: the program was built with --asan, and has room for red zones.
 * img: the program; NULL: a region has no text of it. Returns false if this computer has no address space
 * left. */
bool span_take(struct node *n, const struct node_image *img, size_t program_bytes, size_t above_bytes,
               bool long32, bool asan);
/* Guards the space behind the heap, if there is to be a guard and it is not there yet. To be called before
 * the node uses the heap: a guard takes a page of the host's page tables, and many programs have no heap. */
void span_guard_heap(struct node *n);
/* Takes span and heap from n, if it has any. */
void span_release(struct node *n);
#endif
