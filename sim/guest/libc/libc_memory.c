/* libc_memory.c - malloc and related calls, from the node's own heap; and longjmp, by which the stack loses
 * frames. No handler can interrupt them, since none of them enters an NX call; so handlers may use them, too.
 */
#include <errno.h>
#include <malloc.h>
#include <stdint.h>
#include <string.h>
#include "guest/heap.h"
#include "kernel/crossing.h"
#include "node/node.h"
#include "node/self.h"
#include "node/system.h"
#include "nx_api/contract/backend.h"
#include "os/asan_hooks.h"
#include "os/fail.h"
#include "os/memory.h"
#include "os/observer.h"

void *node_malloc(size_t bytes);
int node_getpagesize(void);

enum { LEAST_ALIGN = 16 }; /* of what malloc gives */

static void note_refusal(struct node *n, size_t bytes)
{
    struct node_refusal *r = &n->cold->refusal;
    *r = (struct node_refusal){.bytes = bytes, .used = node_memory_claimed(n), .heap = n->memory.heap};
    if (n->sys->calls_from)
        r->depth = n->sys->calls_from(n, (uintptr_t)crossing_frame(), r->returns, REFUSAL_CALLS);
}

/* Returns p, the answer to an allocation, or what a checked program gets in its place. A refused allocation
 * is noted for the report, since programs rarely check. */
static void *answer(struct node *n, void *p, size_t align, size_t bytes)
{
    if (p == NULL) {
        note_refusal(n, bytes);
        errno = ENOMEM;
    } else if (n->asan) {
        p = asan_give(n, p, align, bytes, __builtin_frame_address(0));
    }
    ANNOUNCE(n, allocated, p, bytes);
    return p;
}

/* Ends the program: it passed to `call` a pointer that is not a block of its heap. */
static _Noreturn void refuse(struct node *n, const char *call, const void *p)
{
    node_fail(n, "%s: %p was not allocated, is freed already, or was written past its end", call, p);
}

void *node_malloc(size_t bytes)
{
    struct node *n = node_self();
    return answer(n, node_heap_alloc(n->guest.heap, bytes), LEAST_ALIGN, bytes);
}

void *node_aligned_alloc(size_t align, size_t bytes)
{
    struct node *n = node_self();
    if (__builtin_popcountl(align) == 1)
        return answer(n, node_heap_alloc_aligned(n->guest.heap, align, bytes), align, bytes);
    errno = EINVAL;
    return NULL;
}

void *node_memalign(size_t align, size_t bytes)
{
    return node_aligned_alloc(align, bytes);
}

void *node_valloc(size_t bytes)
{
    return node_aligned_alloc((size_t)node_getpagesize(), bytes);
}

int node_posix_memalign(void **p, size_t align, size_t bytes)
{
    int before = errno;
    void *block = align % sizeof(void *) ? NULL : node_aligned_alloc(align, bytes);
    int error = block ? 0 : align % sizeof(void *) ? EINVAL : errno;
    errno = before;
    if (block)
        *p = block;
    return error;
}

void *node_calloc(size_t count, size_t size)
{
    struct node *n = node_self();
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes))
        return answer(n, NULL, LEAST_ALIGN, SIZE_MAX);
    void *p = answer(n, node_heap_alloc(n->guest.heap, bytes), LEAST_ALIGN, bytes);
    return p == NULL ? NULL : memset(p, 0, bytes);
}

/* --- of checked programs: os/asan_hooks.h --- */

static void free_checked(struct node *n, void *p, const char *call)
{
    void *counted = asan_counted(n, call, p, __builtin_frame_address(0));
    asan_take(n, p, __builtin_frame_address(0));
    node_heap_release(n->guest.heap, counted);
}

/* Each block moves, so that an old pointer to it is noticed. */
static void *resize_checked(struct node *n, void *p, size_t bytes)
{
    void *counted = asan_counted(n, "realloc", p, __builtin_frame_address(0));
    size_t before = asan_bytes(p);
    void *q = answer(n, node_heap_resize(n->guest.heap, counted, bytes), LEAST_ALIGN, bytes);
    if (q == NULL)
        return NULL;
    memcpy(q, p, before < bytes ? before : bytes);
    asan_take(n, p, __builtin_frame_address(0));
    return q;
}

/* --- */

void node_free(void *p)
{
    struct node *n = node_self();
    if (n->asan) {
        if (p != NULL)
            free_checked(n, p, "free");
        return;
    }
    ANNOUNCE(n, freed, p, node_heap_bytes(n->guest.heap, p));
    if (p != NULL && node_heap_release(n->guest.heap, p) != 0)
        refuse(n, "free", p);
}

/* Size 0 frees the block, as in glibc. */
static void *resize(struct node *n, void *p, size_t bytes)
{
    if (!node_heap_owns(n->guest.heap, p))
        refuse(n, "realloc", p);
    if (bytes > 0)
        return answer(n, node_heap_resize(n->guest.heap, p, bytes), LEAST_ALIGN, bytes);
    node_heap_release(n->guest.heap, p);
    return NULL;
}

void *node_realloc(void *p, size_t bytes)
{
    struct node *n = node_self();
    if (p == NULL)
        return answer(n, node_heap_alloc(n->guest.heap, bytes), LEAST_ALIGN, bytes);
    if (!n->asan)
        return resize(n, p, bytes);
    if (bytes > 0)
        return resize_checked(n, p, bytes);
    free_checked(n, p, "realloc");
    return NULL;
}

char *node_strndup(const char *s, size_t most)
{
    size_t len = strnlen(s, most);
    char *copy = node_malloc(len + 1);
    if (copy != NULL) {
        memcpy(copy, s, len);
        copy[len] = 0;
    }
    return copy;
}

char *node_strdup(const char *s)
{
    return node_strndup(s, strlen(s));
}

/* UNIX's end of the program's memory, and how it moves. Only the low 32 bits of sbrk's argument count, as
 * signed: programs call it undeclared. */
void *node_sbrk(int by)
{
    struct node *n = node_self();
    void *before = node_heap_break(n->guest.heap);
    if (node_heap_move_break(n->guest.heap, by))
        return before;
    if (by > 0)
        note_refusal(n, (size_t)by);
    errno = ENOMEM;
    return (void *)-1;
}

int node_brk(char *end)
{
    struct node *n = node_self();
    if (node_heap_move_break(n->guest.heap, end - (char *)node_heap_break(n->guest.heap)))
        return 0;
    errno = ENOMEM;
    return -1;
}

/* Counts in the fields that System V had, as ints. */
struct mallinfo node_mallinfo(void);
struct mallinfo node_mallinfo(void)
{
    const struct node_heap *h = node_self()->guest.heap;
    size_t free_blocks, all = node_heap_used(h), used = node_heap_in_use(h, &free_blocks);
    return (struct mallinfo){
        .arena = (int)all, .ordblks = (int)free_blocks, .uordblks = (int)used, .fordblks = (int)(all - used)};
}

/* --- jumps --- */

_Noreturn void node_longjmp(void *where, int value);
_Noreturn void node_siglongjmp(void *where, int value);

/* What a checked program's frames have marked goes with them. */
_Noreturn void node_longjmp(void *where, int value)
{
    struct node *n = node_self();
    if (n->asan)
        asan_jumped(n);
    if (!crossing_may_jump(where))
        node_fail(n, "longjmp: the function that called setjmp has ended");
    crossing_jump(where, value);
}

_Noreturn void node_siglongjmp(void *where, int value)
{
    node_longjmp(where, value);
}
