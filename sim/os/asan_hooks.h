/* asan_hooks.h - what a node does with memory of its program, told to the checker of accesses (sim/asan),
 * which implements these functions. Programs built with nxcc --asan have one (n->asan).
 *
 * An access outside of what the program has ends the program: these functions do not return then. All are
 * called on the node's stack, on any thread. `frame` is that of a function which the program has called. */
#ifndef OS_ASAN_HOOKS_H
#define OS_ASAN_HOOKS_H
#include "node/system.h"

struct nxc_race_site;

/* The program, or a library function that it calls at a site, accesses memory. */
void asan_told(struct node *n, const void *at, size_t bytes, const struct nxc_race_site *site,
               const void *frame);
/* A call of NX reads the program's memory, or writes it. */
void asan_in_call(struct node *n, bool write, const void *at, size_t bytes, const void *frame);
#define ASAN_CALL(n, write, at, bytes)                                                                       \
    do {                                                                                                     \
        if (__builtin_expect((n)->asan != NULL, 0))                                                          \
            asan_in_call((n), (write), (at), (bytes), __builtin_frame_address(0));                           \
    } while (0)
/* A call, also of a library that is a part of the program, does that; NULL: a handler's message comes. */
void asan_in_library(struct node *n, const char *call, bool write, const void *at, size_t bytes,
                     const void *frame);
/* All frames of the program may be gone: red zones of local variables are forgotten. */
void asan_jumped(struct node *n);

/* --- the heap --- */

/* Gives out a block of so many bytes, for which the node's heap has given `counted`, at a multiple of align,
 * a power of two. The block lies elsewhere, between red zones. */
void *asan_give(struct node *n, void *counted, size_t align, size_t bytes, const void *frame);
/* What the node's heap has given for a block that the program passes to `call`. */
void *asan_counted(struct node *n, const char *call, const void *block, const void *frame);
/* Takes a block back. It is given out again much later. */
void asan_take(struct node *n, void *block, const void *frame);
/* The bytes that the program has asked for in a block. */
size_t asan_bytes(const void *block);
#endif
