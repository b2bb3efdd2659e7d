/* span.c - see span.h. */
#include "guest/span.h"
#include <assert.h>
#include <stdio.h>
#include <sys/mman.h>
#include "guest/span_texts.h"
#include "node/system.h"
#include "node/self.h"
#include "os/memory.h"

#ifndef MADV_GUARD_INSTALL
#define MADV_GUARD_INSTALL 102
#endif

enum {
    PAGE = 4096,
    TABLE = 4 * PAGE,    /* at the start of a region's first span */
    HEAD = TABLE + PAGE, /* of each span: the table, and a guard */
    GUARD = 16 * PAGE,   /* below programs' stacks, behind programs and heaps */
    LEAST_SHIFT = 18,    /* of a span */
    COLOURS = 64,        /* stacks begin at so many different lines of a page */
    LINE = 64,           /* bytes of a cache line */
    ENTRIES = 8,         /* of a page table in a cache line */
    ASAN_STACK = 2,      /* with red zones a stack takes so many times the room, */
    ASAN_HEAP = 3,       /* and a heap, of which freed blocks are not given out again at once */
};

/* The most bytes of a region: a heap can have so many (heap.c). */
#define LONGEST ((size_t)64 << 30)

/* A region's table has room for so many. */
enum { MOST_SPANS = (TABLE - sizeof(struct node_region)) / sizeof(struct node *) };

static size_t page_up(size_t bytes)
{
    return (bytes + PAGE - 1) / PAGE * PAGE;
}

static size_t most_nodes(const struct node_system *sys)
{
    return sys->count > sys->topo.positions ? sys->count : sys->topo.positions;
}

/* --- guards --- */

/* The mappings that this process may have, less those that it has for other purposes. */
static size_t most_mappings(const struct node_system *sys)
{
    enum { USUAL = 65530, OTHERS = 2000 };
    size_t most = USUAL;
    FILE *f = sys->most_mappings ? NULL : fopen("/proc/sys/vm/max_map_count", "r");
    if (f) {
        if (fscanf(f, "%zu", &most) != 1)
            most = USUAL;
        fclose(f);
    }
    most = sys->most_mappings ? sys->most_mappings : most;
    return most > OTHERS ? most - OTHERS : 0;
}

/* Has the kernel guards that are no mappings? Tried on a page that is not used otherwise. */
static bool has_light_guards(void *page)
{
    return madvise(page, PAGE, MADV_GUARD_INSTALL) == 0;
}

/* Chooses guards so that all nodes' mappings are allowed. With all guards a node has these mappings: guard,
 * stack, guard, stack, text, data; heap, guard. */
static void choose_mappings(struct node_region *r, struct node_system *sys)
{
    size_t nodes = most_nodes(sys);
    size_t most = most_mappings(sys);
    r->light_guards = !sys->most_mappings && has_light_guards((char *)r + TABLE);
    r->copies_text = nodes * (r->light_guards ? 2 : 8) > most;
    r->guards = r->light_guards || nodes * 6 <= most ? NODE_GUARDS_ALL
                : nodes * 4 <= most                  ? NODE_GUARDS_STACKS
                                                     : NODE_GUARDS_NONE;
    if (r->guards < sys->guards)
        sys->guards = r->guards;
}

static bool guard(const struct node_region *r, char *from, char *to)
{
    if (from >= to)
        return true;
    return r->light_guards ? madvise(from, (size_t)(to - from), MADV_GUARD_INSTALL) == 0
                           : mprotect(from, (size_t)(to - from), PROT_NONE) == 0;
}

/* --- regions --- */

static uint32_t shift_for(size_t bytes)
{
    uint32_t shift = LEAST_SHIFT;
    while ((size_t)1 << shift < bytes)
        shift++;
    return shift;
}

/* Maps memory that is zero and costs nothing until it is touched. */
static void *fresh(void *where, size_t bytes, int flags)
{
    return mmap(where, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | flags, -1,
                0);
}

/* Reserves a region wherever one may begin; NULL if there is no room. */
static void *reserve_anywhere(size_t bytes)
{
    char *wide = fresh(NULL, bytes + NODE_REGION, 0);
    if (wide == MAP_FAILED)
        return NULL;
    char *region = wide + ((NODE_REGION_AT - (uintptr_t)wide) & (NODE_REGION - 1));
    if (region > wide)
        munmap(wide, (size_t)(region - wide));
    munmap(region + bytes, (size_t)(wide + NODE_REGION - region));
    return region;
}

/* Reserves the first free region from `from`, where one may begin, and below `to`; NULL if there is none. */
static void *reserve_between(uintptr_t from, uintptr_t to, size_t bytes)
{
    for (uintptr_t at = from; at + bytes <= to; at += NODE_REGION) {
        void *region = fresh((void *)at, bytes, MAP_FIXED_NOREPLACE);
        if (region == (void *)at)
            return region;
        if (region != MAP_FAILED)
            munmap(region, bytes); /* an old kernel takes the address as a hint */
    }
    return NULL;
}

/* Hosts have nothing of their own at these addresses, so programs find equal addresses in every run,
 * whatever they do with them. (ThreadSanitizer has its tables at the other one.) Regions have bit 31 set: the
 * lower half of an address, which a program has kept in an int, is negative, and nobody's address. Without
 * the bit it could be one in the memory of a node whose region is a low one. */
#ifdef __SANITIZE_THREAD__
enum { FIRST_SHIFT = 36, TRIES = 2048 };
#else
enum { FIRST_SHIFT = 45, TRIES = 40000 }; /* a million nodes of 16 MB take 16,000, every other two */
#endif

const struct span_range SPAN_RANGES[2] = {
    [SPAN_USUAL] = {(uintptr_t)1 << FIRST_SHIFT, ((uintptr_t)1 << FIRST_SHIFT) + TRIES *NODE_REGION},
    [SPAN_LOW] = {0, (uintptr_t)1 << 32}};

static bool make_executable(void *from, size_t bytes)
{
    return mprotect(from, bytes, PROT_READ | PROT_WRITE | PROT_EXEC) == 0;
}

/* Maps the machine's texts in place of a region's spans, if they fit and the host has its guards there, too.
 * (Linux 6.13 has them in other memory only.) Else makes the spans executable, for copies of the text. */
static bool map_texts(struct node_region *r, struct node_system *sys)
{
    struct node_region made = *r;
    if (!sys->texts)
        sys->texts = span_texts_new(r->spans, (uint32_t)r->shift);
    if (!sys->texts || !span_texts_fit(sys->texts, r->spans, (uint32_t)r->shift))
        return make_executable(r, r->heaps_at);
    if (!span_texts_map(sys->texts, (char *)r, 0, r->heaps_at))
        return false;
    made.has_texts = !made.light_guards || has_light_guards((char *)r + TABLE);
    bool done =
        made.has_texts || (fresh(r, r->heaps_at, MAP_FIXED) == r && make_executable(r, made.heaps_at));
    if (done)
        *r = made;
    return done;
}

static void *reserve(struct node_system *sys, size_t bytes)
{
    const struct span_range *usual = &SPAN_RANGES[SPAN_USUAL];
    uintptr_t from = sys->regions_end ? sys->regions_end : usual->from + NODE_REGION_AT;
    void *region = reserve_between(from | (uintptr_t)1 << 31, usual->to, bytes);
    if (!region)
        return reserve_anywhere(bytes);
    sys->regions_end = (uintptr_t)region + bytes;
    return region;
}

static void *reserve_low(size_t bytes)
{
    const struct span_range *low = &SPAN_RANGES[SPAN_LOW];
    return reserve_between(low->from + NODE_REGION_AT, low->to, bytes);
}

/* NODE_REGION, or a multiple of it for one large heap. */
static size_t region_bytes(size_t span_bytes, size_t heap_bytes)
{
    size_t one = ((size_t)1 << shift_for(span_bytes)) + heap_bytes + GUARD;
    return (one + NODE_REGION - 1) / NODE_REGION * NODE_REGION;
}

static struct node_region *region_new(struct node_system *sys, size_t span_bytes, size_t heap_bytes, bool low)
{
    size_t bytes = region_bytes(span_bytes, heap_bytes);
    struct node_region *r = low ? reserve_low(bytes) : reserve(sys, bytes);
    if (!r)
        return NULL;
    r->bytes = bytes;
    r->shift = shift_for(span_bytes);
    r->heap_bytes = heap_bytes;
    r->heap_stride = heap_bytes + GUARD;
    size_t fit = bytes / (r->heap_stride + ((size_t)1 << r->shift));
    r->spans = (uint32_t)(fit < MOST_SPANS ? fit : MOST_SPANS);
    r->heaps_at = (uint64_t)r->spans << r->shift;
    r->low = low;
    choose_mappings(r, sys);
    if (r->copies_text && !map_texts(r, sys)) {
        munmap(r, bytes);
        return NULL;
    }
    r->next = sys->roomy;
    return sys->roomy = r;
}

static struct node_region *roomy_region(struct node_system *sys, size_t span_bytes, size_t heap_bytes,
                                        bool low)
{
    struct node_region *r = sys->roomy;
    while (r && ((size_t)1 << r->shift < span_bytes || r->heap_bytes < heap_bytes || r->low != low))
        r = r->next;
    return r ? r : region_new(sys, span_bytes, heap_bytes, low);
}

static void unlink_region(struct node_system *sys, struct node_region *r)
{
    struct node_region **link = &sys->roomy;
    while (*link != r)
        link = &(*link)->next;
    *link = r->next;
}

/* --- spans --- */

/* Makes a span and a heap new: another node has used them, or the span has the text of another program. */
static bool renew(const struct node_region *r, const struct node *n)
{
    size_t kept = n->guest.span == (const char *)r ? TABLE : 0, bytes = ((size_t)1 << r->shift) - kept;
    char *span = n->guest.span + kept;
    if (fresh(n->guest.heap_start, r->heap_stride, MAP_FIXED) == MAP_FAILED)
        return false;
    if (n->guest.text != TEXT_OWN)
        return span_texts_map(n->sys->texts, span, (size_t)(span - (const char *)r), bytes);
    return fresh(span, bytes, MAP_FIXED) != MAP_FAILED && (!r->copies_text || make_executable(span, bytes));
}

/* Guards the space below the stacks, and behind the program. */
static bool make_guards(const struct node_region *r, const struct node *n, size_t program_bytes)
{
    char *head = n->guest.span == (const char *)r ? n->guest.span + TABLE : n->guest.span;
    char *system_end = n->guest.system_stack + NODE_SYSTEM_STACK;
    char *end = n->guest.program + program_bytes, *span_end = n->guest.span + ((size_t)1 << r->shift);
    if (r->guards == NODE_GUARDS_NONE)
        return true;
    if (r->light_guards) { /* they cost for each page */
        head = n->guest.system_stack - PAGE;
        span_end = end + GUARD < span_end ? end + GUARD : span_end;
    }
    return guard(r, head, n->guest.system_stack) && guard(r, system_end, n->guest.stack) &&
           (r->guards == NODE_GUARDS_STACKS || guard(r, end, span_end));
}

void span_guard_heap(struct node *n)
{
    const struct node_region *r = n->guest.region;
    char *end = n->guest.heap_start + r->heap_bytes;
    if (n->guest.heap_guarded || r->guards != NODE_GUARDS_ALL)
        return;
    n->guest.heap_guarded = true;
    guard(r, end, end + GUARD);
}

/* Sets the addresses of a node's parts. At equal offsets in their spans, all nodes' frames would compete
 * for a few sets of the caches, and so would their entries of the page tables. Therefore the stack's top
 * keeps off the program's start by a number of lines that differs from the neighbours'; and the program
 * begins further on in the span by a number of pages, as far as there is room, so that its entries lie in
 * another line. */
static void lay_out(struct node *n, size_t slot, size_t used_bytes, size_t stack_bytes, size_t above_bytes)
{
    const struct node_region *r = n->guest.region;
    n->guest.span = (char *)r + (slot << r->shift);
    n->guest.heap_start = (char *)r + r->heaps_at + slot * r->heap_stride;
    size_t most = (((size_t)1 << r->shift) - used_bytes) / (ENTRIES * PAGE) + 1;
    n->guest.system_stack = n->guest.span + HEAD + slot % most * ENTRIES * PAGE;
    n->guest.stack = n->guest.system_stack + NODE_SYSTEM_STACK + GUARD;
    n->guest.program = n->guest.stack + stack_bytes + PAGE;
    n->guest.stack_bytes = (size_t)(n->guest.program - n->guest.stack) - slot % COLOURS * LINE - above_bytes;
}

/* The address space of a heap: the node's memory, at most what fits beside a span into NODE_REGION, or into
 * the node's part of half of the usual addresses. */
static size_t heap_room(const struct node *n, size_t span_bytes, bool long32, bool asan)
{
    const struct span_range *usual = &SPAN_RANGES[SPAN_USUAL];
    size_t part = (usual->to - usual->from) / 2 / most_nodes(n->sys) / NODE_REGION * NODE_REGION;
    size_t region = long32 || part < NODE_REGION ? NODE_REGION : part < LONGEST ? part : LONGEST;
    size_t most = region - ((size_t)1 << shift_for(span_bytes)) - GUARD;
    size_t wanted = page_up(node_memory_limit(n)) * (asan ? ASAN_HEAP : 1);
    return wanted < most ? wanted : most;
}

bool span_take(struct node *n, const struct node_image *img, size_t program_bytes, size_t above_bytes,
               bool long32, bool asan)
{
    struct node_system *sys = n->sys;
    size_t stack = page_up(sys->cfg->stack_bytes) * (asan ? ASAN_STACK : 1) + page_up(above_bytes);
    size_t bytes = HEAD + NODE_SYSTEM_STACK + GUARD + stack + 2 * PAGE + program_bytes;
    size_t heap = heap_room(n, bytes, long32, asan);
    struct node_region *r = long32 ? roomy_region(sys, bytes, heap, true) : NULL;
    if (!r)
        r = roomy_region(sys, bytes, heap, false);
    if (!r)
        return false;
    assert(program_bytes % PAGE == 0 && !n->guest.region);
    size_t slot = r->fresh;
    bool used = slot == r->spans;
    if (used)
        for (slot = 0; r->node[slot]; slot++)
            ;
    else
        r->fresh++;
    assert(slot < r->spans);
    n->guest.region = r;
    r->node[slot] = n;
    if (++r->used == r->spans)
        unlink_region(sys, r);
    lay_out(n, slot, bytes, stack, above_bytes);
    n->guest.text = r->has_texts && img
                        ? span_texts_claim(sys->texts, img, (size_t)(n->guest.program - (char *)r))
                        : TEXT_OWN;
    used |= r->has_texts && n->guest.text == TEXT_OWN;
    return (!used || renew(r, n)) && make_guards(r, n, program_bytes);
}

void span_release(struct node *n)
{
    struct node_region *r = n->guest.region;
    if (!r)
        return;
    size_t slot = (size_t)(n->guest.span - (char *)r) >> r->shift;
    assert(r->used > 0 && r->node[slot] == n);
    if (r->used-- == r->spans) {
        r->next = n->sys->roomy;
        n->sys->roomy = r;
    }
    r->node[slot] = NULL;
    n->guest.region = NULL;
    if (r->used)
        return;
    unlink_region(n->sys, r);
    munmap(r, r->bytes);
}
