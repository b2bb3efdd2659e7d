/* node_asan.h - the checker of one node's accesses. For the files of this folder; asan_check.h is for others.
 *
 * The node's heap (guest/heap.h) counts: it decides whether there is room for a block, and how much of the
 * node's memory is in use, as without --asan. Its blocks are nobody's. What the program gets lies in memory
 * beside it, between red zones, and is given out again only when much else has been freed:
 *
 *     n->guest.heap, elsewhere       | counted |
 *                                         ^
 *     blocks, at n->guest.heap_start | asan_block | the program's bytes | red zone |
 */
#ifndef ASAN_NODE_ASAN_H
#define ASAN_NODE_ASAN_H
#include "asan/asan_shadow.h"
#include "asan/asan_stacks.h"
#include "guest/heap.h"
#include "node/node.h"
#include "nx_api/contract/asan.h"

/* In the red zone before a block's bytes. */
struct asan_block {
    uint64_t tag;  /* asan_blocks.c */
    void *whole;   /* what node_asan.blocks has given */
    void *counted; /* and the node's heap; NULL: the program has freed the block */
    size_t bytes;
    uint32_t allocated, freed; /* node_asan.stacks; 0: not known, or not freed */
    uint64_t unused;
};

struct node_asan {
    struct asan_shadow shadow; /* of the node's region: machine's */
    struct node_heap *blocks;
    char *counted; /* the addresses of the node's heap */
    size_t counted_bytes;
    uintptr_t marked;          /* the heap's shadow says up to here that nothing is the program's */
    struct asan_block **freed; /* not given out again yet: a ring, the oldest at freed_first */
    size_t freed_first, freed_count, freed_room, freed_bytes;
    struct asan_stacks *stacks;
};

/* --- asan_blocks.c --- */

/* The block in whose bytes, or nearest to which, an address of the heap lies; NULL: there is none. */
const struct asan_block *asan_block_near(const struct node *n, uintptr_t at);
static inline uintptr_t asan_block_begin(const struct asan_block *b)
{
    return (uintptr_t)(b + 1);
}

/* --- asan_report.c --- */

struct asan_access {
    uintptr_t at, bad; /* where it begins; its first byte that is not the program's */
    size_t bytes;
    bool write;
    const struct nxc_race_site *site; /* NULL: a call of NX, or of MPI */
    const char *call;                 /* its name; NULL: none, a message has come */
    const void *frame;
};

/* Is a return address, so many bytes from the program's beginning, in what nxcc adds to programs? */
bool asan_is_of_nxcc(const struct node *n, size_t returns);
/* Ends the program with a report. */
_Noreturn void asan_report(struct node *n, const struct asan_access *a);
/* `call` was given what is no block in use. */
_Noreturn void asan_report_block(struct node *n, const char *call, const void *block, const void *frame);
#endif
