/* self.h - which node an address belongs to, and which node runs. */
#ifndef NODE_SELF_H
#define NODE_SELF_H
#include "node/node.h"

#define NODE_REGION ((uintptr_t)1 << 30)

/* Bytes of the stack on which the system runs: what the C library takes at most, and some more. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { NODE_SYSTEM_STACK = 512 << 10 };
#else
enum { NODE_SYSTEM_STACK = 128 << 10 };
#endif

/* What is guarded against running over: in the order of what it costs. */
enum node_guards { NODE_GUARDS_NONE, NODE_GUARDS_STACKS, NODE_GUARDS_ALL };

/* The start of a region: which nodes its spans and heaps belong to, and how they are made. */
struct node_region {
    uint64_t shift;                 /* a span has 2^shift bytes */
    uint64_t heaps_at, heap_stride; /* offset of the first heap, and from each to the next */
    uint64_t heap_bytes;            /* of each, less than heap_stride */
    uint32_t spans, fresh, used;    /* spans: in all; the first that nobody has had yet; taken */
    enum node_guards guards;
    bool light_guards, copies_text, low; /* low: below 2^32 */
    struct node_region *next;            /* with room: node_system.roomy */
    struct node *node[];                 /* by span */
};

/* The node in whose memory an address lies: in the program, its stack or its heap. It has to lie in some
 * node's region. */
static inline struct node *node_at_address(uintptr_t address)
{
    const struct node_region *r = (const struct node_region *)(address & ~(NODE_REGION - 1));
    uint64_t offset = address & (NODE_REGION - 1);
    uint64_t slot = offset < r->heaps_at ? offset >> r->shift : (offset - r->heaps_at) / r->heap_stride;
    return r->node[slot];
}

/* The node that runs the caller: on its stack, or on one that the program has made in its own memory. */
static inline struct node *node_self(void)
{
    return node_at_address((uintptr_t)__builtin_frame_address(0));
}

/* Does an address lie in its memory? */
static inline bool node_owns(const struct node *n, uintptr_t address)
{
    const struct node_region *r = n->region;
    return r && (address - (uintptr_t)n->span < (uintptr_t)1 << r->shift ||
                 address - (uintptr_t)n->heap_start < r->heap_bytes);
}

/* May an address be that of a frame (two words) on the system's stack or the program's? */
static inline bool node_may_be_frame(const struct node *n, uintptr_t address)
{
    uintptr_t end = (uintptr_t)n->stack + n->stack_bytes - 2 * sizeof address;
    return address >= (uintptr_t)n->system_stack && address < end && address % sizeof address == 0;
}

/* Does the caller run on this node? */
static inline bool node_is_self(const struct node *n)
{
    return node_owns(n, (uintptr_t)__builtin_frame_address(0));
}
#endif
