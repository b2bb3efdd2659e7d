/* span.c - see span.h. */
#include "node/span.h"
#include <stdio.h>
#include <sys/mman.h>
#include "node/system.h"

#ifndef MADV_GUARD_INSTALL
#define MADV_GUARD_INSTALL 102
#endif

enum {
    PAGE = 4096,
    HEAD = 16 * PAGE, /* of a span: the region's table, and room for other things to run into */
    TABLE = 4 * PAGE, /* of the head, in a region's first span */
    LEAST_SHIFT = 20, /* of a span */
    COLOURS = 64,
    LINE = 64,   /* stacks start at so many places of a page */
    ENTRIES = 8, /* of the page tables, in a line */
};
#define SPANS(r) (NODE_REGION >> (r)->shift)

_Static_assert(sizeof(struct node_region) + (NODE_REGION >> LEAST_SHIFT) * sizeof(struct node *) <= TABLE,
               "a region's table does not fit");

static size_t page_up(size_t bytes)
{
    return (bytes + PAGE - 1) / PAGE * PAGE;
}

/* --- regions --- */

/* Mappings that this process may have, less what else it has. */
static size_t most_mappings(void)
{
    enum { USUAL = 65530, OTHERS = 2000 };
    size_t most = USUAL;
    FILE *f = fopen("/proc/sys/vm/max_map_count", "r");
    if (f) {
        if (fscanf(f, "%zu", &most) != 1)
            most = USUAL;
        fclose(f);
    }
    return most > OTHERS ? most - OTHERS : 0;
}

/* Has the kernel guards that are no mappings? Tried on memory of no use. */
static bool has_light_guards(void *page)
{
    return madvise(page, PAGE, MADV_GUARD_INSTALL) == 0;
}

static void choose_mappings(struct node_region *r, size_t nodes)
{
    size_t most = most_mappings();
    r->light_guards = has_light_guards((char *)r + TABLE);
    r->copies_text = nodes * (r->light_guards ? 2 : 4) > most;
    r->guards = r->light_guards || !r->copies_text || nodes * 2 <= most;
}

static uint32_t shift_for(size_t bytes)
{
    uint32_t shift = LEAST_SHIFT;
    while ((size_t)1 << shift < bytes)
        shift++;
    return shift;
}

/* Memory that is zero and costs nothing until it is touched. */
static void *fresh(void *where, size_t bytes, int flags)
{
    return mmap(where, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | flags, -1,
                0);
}

/* A mapping at a multiple of its size; NULL when there is no room. */
static struct node_region *reserve(void)
{
    char *wide = fresh(NULL, 2 * NODE_REGION, 0);
    if (wide == MAP_FAILED)
        return NULL;
    char *region = (char *)(((uintptr_t)wide + NODE_REGION - 1) & ~(NODE_REGION - 1));
    if (region > wide)
        munmap(wide, (size_t)(region - wide));
    munmap(region + NODE_REGION, (size_t)(wide + NODE_REGION - region));
    return (struct node_region *)region;
}

static void drop(struct node_region *r)
{
    if (r->heaps != MAP_FAILED)
        munmap(r->heaps, SPANS(r) * r->heap_bytes);
    munmap(r, NODE_REGION);
}

static struct node_region *region_new(struct node_system *sys, size_t span_bytes, size_t heap_bytes)
{
    struct node_region *r = reserve();
    if (!r)
        return NULL;
    r->shift = shift_for(span_bytes);
    r->heap_bytes = heap_bytes;
    r->heaps = fresh(NULL, SPANS(r) * heap_bytes, 0);
    choose_mappings(r, sys->count > sys->topo.positions ? sys->count : sys->topo.positions);
    if (r->heaps == MAP_FAILED ||
        (r->copies_text && mprotect(r, NODE_REGION, PROT_READ | PROT_WRITE | PROT_EXEC))) {
        drop(r);
        return NULL;
    }
    r->next = sys->roomy;
    return sys->roomy = r;
}

/* --- spans --- */

/* A span and a heap that were another's before become as new. */
static bool renew(const struct node_region *r, const struct node *n)
{
    size_t kept = n->span == (const char *)r ? TABLE : 0, bytes = ((size_t)1 << r->shift) - kept;
    char *span = n->span + kept;
    return fresh(span, bytes, MAP_FIXED) != MAP_FAILED &&
           (!r->copies_text || mprotect(span, bytes, PROT_READ | PROT_WRITE | PROT_EXEC) == 0) &&
           fresh(n->heap_start, r->heap_bytes, MAP_FIXED) != MAP_FAILED;
}

static bool make_guard(const struct node_region *r, const struct node *n)
{
    char *guard = n->span + TABLE;
    size_t bytes = (size_t)(n->stack - guard);
    if (!r->guards)
        return true;
    return r->light_guards ? madvise(guard, bytes, MADV_GUARD_INSTALL) == 0
                           : mprotect(guard, bytes, PROT_NONE) == 0;
}

/* Else all nodes' frames would want the same few sets of the caches, and so would the entries of the page tables: the stack's
 * top keeps off the program's start by some lines, as many as neighbours do not; and the program begins so many pages further
 * on in the span, as far as there is room, that its entries lie in another line. */
static void lay_out(struct node *n, size_t slot, size_t used_bytes)
{
    const struct node_region *r = n->region;
    n->span = (char *)r + (slot << r->shift);
    n->heap_start = r->heaps + slot * r->heap_bytes;
    size_t most = (((size_t)1 << r->shift) - used_bytes) / (ENTRIES * PAGE) + 1;
    n->stack = n->span + HEAD + slot % most * ENTRIES * PAGE;
    n->program = n->stack + page_up(n->sys->cfg->stack_bytes) + PAGE;
    n->stack_bytes = (size_t)(n->program - n->stack) - slot % COLOURS * LINE;
}

static struct node_region *region_with_room(struct node_system *sys, size_t span_bytes, size_t heap_bytes)
{
    struct node_region *r = sys->roomy;
    while (r && ((size_t)1 << r->shift < span_bytes || r->heap_bytes < heap_bytes))
        r = r->next;
    return r ? r : region_new(sys, span_bytes, heap_bytes);
}

static void unlink_region(struct node_system *sys, struct node_region *r)
{
    struct node_region **link = &sys->roomy;
    while (*link != r)
        link = &(*link)->next;
    *link = r->next;
}

bool span_take(struct node *n, size_t program_bytes)
{
    struct node_system *sys = n->sys;
    size_t heap = page_up(node_memory_limit(n));
    size_t bytes = HEAD + page_up(sys->cfg->stack_bytes) + 2 * PAGE + program_bytes;
    struct node_region *r = region_with_room(sys, bytes, heap < NODE_REGION ? heap : NODE_REGION);
    if (!r)
        return false;
    size_t slot = r->fresh;
    bool used = slot == SPANS(r);
    if (used)
        for (slot = 0; r->node[slot]; slot++)
            ;
    else
        r->fresh++;
    n->region = r;
    r->node[slot] = n;
    if (++r->used == SPANS(r))
        unlink_region(sys, r);
    lay_out(n, slot, bytes);
    return (!used || renew(r, n)) && make_guard(r, n);
}

void span_release(struct node *n)
{
    struct node_region *r = n->region;
    if (!r)
        return;
    if (r->used-- == SPANS(r)) {
        r->next = n->sys->roomy;
        n->sys->roomy = r;
    }
    r->node[(size_t)(n->span - (char *)r) >> r->shift] = NULL;
    n->region = NULL;
    if (r->used)
        return;
    unlink_region(n->sys, r);
    drop(r);
}
