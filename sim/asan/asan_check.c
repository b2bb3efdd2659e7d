/* asan_check.c - see asan_check.h. */
#include "asan/asan_check.h"
#include <stdlib.h>
#include <sys/mman.h>
#include "asan/node_asan.h"
#include "guest/own_memory.h"
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "node/self.h"
#include "nx_api/contract/program_image.h"
#include "nx_api/contract/races.h"
#include "os/asan_hooks.h"

/* The shadow of a region, which its nodes share: each has its own part. */
struct shared {
    struct asan_shadow shadow;
    struct shared *next;
};

struct asan {
    struct shared *regions;
};

struct asan *asan_new(void)
{
    return xcalloc(1, sizeof(struct asan));
}

void asan_free(struct asan *a)
{
    if (!a)
        return;
    for (struct shared *s = a->regions, *next; s; s = next) {
        next = s->next;
        asan_shadow_end(&s->shadow);
        free(s);
    }
    free(a);
}

static struct asan_shadow *shadow_of(struct asan *a, const struct node_region *r)
{
    struct shared *s = a->regions;
    while (s && s->shadow.low != (uintptr_t)r)
        s = s->next;
    if (s)
        return &s->shadow;
    s = xcalloc(1, sizeof *s);
    if (!asan_shadow_begin(&s->shadow, (uintptr_t)r, NODE_REGION)) {
        free(s);
        return NULL;
    }
    s->next = a->regions;
    a->regions = s;
    return &s->shadow;
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

static bool make_parts(struct node_asan *a, const struct node *n)
{
    size_t heap = n->region->heap_bytes;
    void *counted =
        mmap(NULL, heap, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (counted == MAP_FAILED)
        return false;
    a->counted = counted, a->counted_bytes = heap;
    a->blocks =
        node_heap_new(n->heap_start, n->region->heap_bytes - own_memory_bytes(n), always, ignored, NULL);
    a->marked = (uintptr_t)n->heap_start;
    a->stacks = asan_stacks_new();
    return true;
}

/* From now on the program looks at the shadow, and tells of what it finds there. */
static void start(const struct node *n, const struct asan_shadow *s)
{
    const struct nxc_asan *image = n->image->races->asan;
    *n->image->races->on = 1;
    *image->low = s->low;
    *image->shadow = s->of;
    *image->bytes = s->bytes;
}

struct node_asan *asan_begin(struct asan *all, struct node *n)
{
    const struct asan_shadow *s = shadow_of(all, n->region);
    if (!s)
        return NULL;
    struct node_asan *a = xcalloc(1, sizeof *a);
    a->shadow = *s;
    if (!make_parts(a, n)) {
        free_parts(a);
        return NULL;
    }
    mark_globals(s, n->image->races->asan);
    start(n, s);
    return a;
}

void *asan_heap_base(const struct node_asan *a)
{
    return a->counted;
}

void asan_end(struct node *n)
{
    const struct node_region *r = n->region;
    asan_shadow_forget(&n->asan->shadow, (uintptr_t)n->span, (size_t)1 << r->shift);
    asan_shadow_forget(&n->asan->shadow, (uintptr_t)n->heap_start, r->heap_bytes);
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
    while (asan_is_of_nxcc(n, frame[1] - (uintptr_t)n->program));
    return (uintptr_t)(frame + 2);
}

static bool is_on_stack(const struct node *n, uintptr_t at)
{
    return at - (uintptr_t)n->stack < n->stack_bytes;
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

static void check(struct node *n, struct asan_access *a)
{
    const struct asan_shadow *s = &n->asan->shadow;
    while ((a->bad = asan_shadow_first(s, a->at, a->bytes)) && is_in_use_again(n, a))
        asan_shadow_open_alike(s, a->bad);
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
    asan_in_library(n, n->call, write, at, bytes, frame);
}

void asan_in_library(struct node *n, const char *call, bool write, const void *at, size_t bytes,
                     const void *frame)
{
    check(n, &(struct asan_access){
                 .at = (uintptr_t)at, .bytes = bytes, .write = write, .call = call, .frame = frame});
}

void asan_jumped(struct node *n)
{
    asan_shadow_forget(&n->asan->shadow, (uintptr_t)n->stack, n->stack_bytes);
}
