/* self.h - the node that an address belongs to, and the node that runs. */
#ifndef NODE_SELF_H
#define NODE_SELF_H
#include "node/node.h"

/* Regions lie behind multiples of their size by so many bytes. So the first of the host's address space,
 * which keeps its lowest pages and has the gates (kernel/crossing.c) at 32 MB, holds nodes as any other
 * does. */
#define NODE_REGION ((uintptr_t)1 << 30)
#define NODE_REGION_AT ((uintptr_t)40 << 20)

/* Bytes of the stack on which the system runs: what the C library takes at most, and some more. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { NODE_SYSTEM_STACK = 512 << 10 };
#else
enum { NODE_SYSTEM_STACK = 128 << 10 };
#endif

/* What is guarded against running over: in the order of what it costs. */
enum node_guards { NODE_GUARDS_NONE, NODE_GUARDS_STACKS, NODE_GUARDS_ALL };

/* The start of a region: which nodes its spans belong to, and how spans and heaps are made. */
struct node_region {
    uint64_t bytes;                 /* a multiple of NODE_REGION: more than one for one large heap */
    uint64_t shift;                 /* a span has 2^shift bytes */
    uint64_t heaps_at, heap_stride; /* offset of the first heap, and from each to the next */
    uint64_t heap_bytes;            /* of each, less than heap_stride */
    uint32_t spans, fresh, used;    /* spans: in all; the first that nobody has had yet; taken */
    enum node_guards guards;
    bool light_guards, low;   /* low: below 2^32 */
    bool copies_text;         /* the text has no mapping of its own */
    bool has_texts;           /* the spans are node_system.texts */
    struct node_region *next; /* with room: node_system.roomy */
    struct node *node[];      /* by span */
};

/* The node in whose span an address lies: on one of its stacks, or in the program. It has to lie in some
 * node's span. */
static inline struct node *node_at_address(uintptr_t address)
{
    uintptr_t offset = (address - NODE_REGION_AT) & (NODE_REGION - 1);
    const struct node_region *r = (const struct node_region *)(address - offset);
    return r->node[offset >> r->shift];
}

/* The node that runs the caller, on its system's stack. */
static inline struct node *node_self(void)
{
    return node_at_address((uintptr_t)__builtin_frame_address(0));
}

/* Does an address lie in its memory? */
static inline bool node_owns(const struct node *n, uintptr_t address)
{
    const struct node_region *r = n->guest.region;
    return r && (address - (uintptr_t)n->guest.span < (uintptr_t)1 << r->shift ||
                 address - (uintptr_t)n->guest.heap_start < r->heap_bytes);
}

/* May an address be that of a frame (two words) on the system's stack or the program's? */
static inline bool node_may_be_frame(const struct node *n, uintptr_t address)
{
    uintptr_t end = (uintptr_t)n->guest.stack + n->guest.stack_bytes - 2 * sizeof address;
    return address >= (uintptr_t)n->guest.system_stack && address < end && address % sizeof address == 0;
}

/* Does the caller run on this node? */
static inline bool node_is_self(const struct node *n)
{
    return node_owns(n, (uintptr_t)__builtin_frame_address(0));
}
#endif
