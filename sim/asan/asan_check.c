/* asan_check.c - see asan_check.h. */
#include "asan/asan_check.h"
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>
#include "asan/node_asan.h"
#include "guest/libc/own_memory.h"
#include "guest/span.h"
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "node/self.h"
#include "nx_api/contract/program_image.h"
#include "nx_api/contract/races.h"
#include "os/asan_hooks.h"

struct asan {
    int others; /* asan_shadow_others; -1: not made, since no program needs it */
};

struct asan *asan_new(void)
{
    struct asan *a = xcalloc(1, sizeof *a);
    a->others = -1;
    return a;
}

void asan_free(struct asan *a)
{
    if (a && a->others >= 0)
        close(a->others);
    free(a);
}

/* --- variables of files --- */

static uintptr_t begin_of(const struct nxc_asan_global *g)
{
    return (uintptr_t)&g->at + (uintptr_t)g->at;
}

/* By address; of one, that first which the linker has taken: no common variable, else the largest. */
static int compare(const void *a, const void *b)
{
    const struct nxc_asan_global *x = *(const struct nxc_asan_global *const *)a;
    const struct nxc_asan_global *y = *(const struct nxc_asan_global *const *)b;
    if (begin_of(x) != begin_of(y))
        return begin_of(x) < begin_of(y) ? -1 : 1;
    if (x->common != y->common)
        return x->common ? 1 : -1;
    return x->bytes > y->bytes ? -1 : x->bytes < y->bytes;
}

static void mark_globals(const struct asan_shadow *s, const struct nxc_asan *image)
{
    size_t count = (size_t)(image->globals_end - image->globals_begin);
    const struct nxc_asan_global **all = xcalloc(count + 1, sizeof *all);
    for (size_t i = 0; i < count; i++)
        all[i] = &image->globals_begin[i];
    qsort(all, count, sizeof *all, compare);
    for (size_t i = 0; i < count; i++)
        if (i == 0 || begin_of(all[i]) != begin_of(all[i - 1]))
            asan_shadow_mark(s, begin_of(all[i]) + all[i]->bytes, NXC_ASAN_ZONE, NXC_ASAN_GLOBAL);
    free(all);
}

/* --- a node --- */

static void free_parts(struct node_asan *a)
{
    asan_shadow_end(&a->shadow);
    if (a->blocks)
        node_heap_free(a->blocks);
    if (a->counted)
        munmap(a->counted, a->counted_bytes);
    asan_stacks_free(a->stacks);
    free(a->freed);
    free(a);
}

static int always(void *ctx, size_t bytes)
{
    (void)ctx, (void)bytes;
    return 1;
}

static void ignored(void *ctx, size_t used)
{
    (void)ctx, (void)used;
}

/* Programs know these addresses, by sbrk: they are where this computer has nothing of its own; behind all
 * blocks, and where no nodes are. */
static void *counted_at(const struct node *n)
{
    const struct span_range *usual = &SPAN_RANGES[SPAN_USUAL];
    return n->guest.heap_start + (usual->to - usual->from) + (n->guest.region->low ? usual->to : 0);
}

static bool make_parts(struct node_asan *a, const struct node *n)
{
    size_t heap = n->guest.region->heap_bytes;
    void *counted =
        mmap(counted_at(n), heap, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (counted == MAP_FAILED)
        return false;
    a->counted = counted, a->counted_bytes = heap;
    a->blocks = node_heap_new(n->guest.heap_start, n->guest.region->heap_bytes - own_memory_bytes(n), always,
                              ignored, NULL);
    a->marked = (uintptr_t)n->guest.heap_start;
    a->stacks = asan_stacks_new();
    return true;
}

/* From now on the program looks at the shadow, and tells of what it finds there. */
static void start(const struct node *n, const struct asan_shadow *s)
{
    const struct nxc_asan *image = n->guest.image->races->asan;
    *n->guest.image->races->on = 1;
    *image->low = s->low;
    *image->shadow = s->of;
    *image->bytes = s->bytes;
}

static bool make_shadow(struct asan *all, struct asan_shadow *s, const struct node *n)
{
    const struct node_region *r = n->guest.region;
    if (all->others < 0)
        all->others = asan_shadow_others();
    return all->others >= 0 && asan_shadow_begin(s, (uintptr_t)r, r->bytes, all->others) &&
           asan_shadow_own(s, (uintptr_t)n->guest.span, (size_t)1 << r->shift) &&
           asan_shadow_own(s, (uintptr_t)n->guest.heap_start, r->heap_bytes);
}

struct node_asan *asan_begin(struct asan *all, struct node *n)
{
    struct node_asan *a = xcalloc(1, sizeof *a);
    if (!make_shadow(all, &a->shadow, n) || !make_parts(a, n)) {
        free_parts(a);
        return NULL;
    }
    mark_globals(&a->shadow, n->guest.image->races->asan);
    start(n, &a->shadow);
    return a;
}

void *asan_heap_base(const struct node_asan *a)
{
    return a->counted;
}

void asan_end(struct node *n)
{
    free_parts(n->asan);
}

/* --- what the node tells --- */

/* The stack pointer of the function that accesses memory, or some bytes less; 0: not known, a message has
 * interrupted the program. */
static uintptr_t stack_pointer(const struct node *n, const struct asan_access *a)
{
    const uintptr_t *frame = crossing_frame();
    if (!frame || !a->site)
        return frame ? crossing_stack_pointer() : 0;
    do /* the frames of what nxcc adds to programs */
        frame = (const uintptr_t *)frame[0];
    while (asan_is_of_nxcc(n, frame[1] - (uintptr_t)n->guest.program));
    return (uintptr_t)(frame + 2);
}

static bool is_on_stack(const struct node *n, uintptr_t at)
{
    return at - (uintptr_t)n->guest.stack < n->guest.stack_bytes;
}

/* Below the stack pointer nobody has variables. Above, another frame has taken the place: one that has marked
 * nothing, as of a file compiled without --asan, or for what has no red zone. */
static bool is_in_use_again(const struct node *n, const struct asan_access *a)
{
    uintptr_t pointer;
    if (asan_shadow_why(&n->asan->shadow, a->bad) != NXC_ASAN_RETURNED)
        return false;
    pointer = stack_pointer(n, a);
    return !is_on_stack(n, pointer) || !is_on_stack(n, a->bad) || a->bad >= pointer;
}

/* Outside of the node's region, and where other regions are? */
static bool is_far_node(const struct asan_shadow *s, uintptr_t at)
{
    const struct span_range *r = &SPAN_RANGES[SPAN_USUAL];
    return at - s->low >= s->bytes && at - r->from < r->to - r->from;
}

static void check(struct node *n, struct asan_access *a)
{
    const struct asan_shadow *s = &n->asan->shadow;
    while ((a->bad = asan_shadow_first(s, a->at, a->bytes)) && is_in_use_again(n, a))
        asan_shadow_open_alike(s, a->bad);
    if (is_far_node(s, a->at))
        a->bad = a->at;
    if (a->bad)
        asan_report(n, a);
}

void asan_told(struct node *n, const void *at, size_t bytes, const struct nxc_race_site *site,
               const void *frame)
{
    check(n, &(struct asan_access){.at = (uintptr_t)at,
                                   .bytes = bytes,
                                   .write = site->flags & NXC_RACE_WRITE,
                                   .site = site,
                                   .frame = frame});
}

void asan_in_call(struct node *n, bool write, const void *at, size_t bytes, const void *frame)
{
    asan_in_library(n, n->call.name, write, at, bytes, frame);
}

void asan_in_library(struct node *n, const char *call, bool write, const void *at, size_t bytes,
                     const void *frame)
{
    check(n, &(struct asan_access){
                 .at = (uintptr_t)at, .bytes = bytes, .write = write, .call = call, .frame = frame});
}

void asan_jumped(struct node *n)
{
    asan_shadow_forget(&n->asan->shadow, (uintptr_t)n->guest.stack, n->guest.stack_bytes);
}
