/* libc_memory.c - malloc and related calls, from the node's own heap. No handler can interrupt them, since
 * none of them enters an NX call; so handlers may use them, too. */
#include <errno.h>
#include <stdint.h>
#include <string.h>
#include "guest/heap.h"
#include "node/node.h"
#include "node/self.h"
#include "nx_api/contract/backend.h"
#include "os/race_hooks.h"

void *node_malloc(size_t bytes);
int node_getpagesize(void);

/* Returns p, the answer to an allocation. A refused allocation is noted for the report, since programs
 * rarely check. */
static void *answer(struct node *n, void *p, size_t bytes)
{
    if (p == NULL) {
        n->failed_malloc = bytes;
        errno = ENOMEM;
    }
    RACES(n, allocated, p, bytes);
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
    return answer(n, node_heap_alloc(n->heap, bytes), bytes);
}

void *node_aligned_alloc(size_t align, size_t bytes)
{
    struct node *n = node_self();
    if (__builtin_popcountl(align) == 1)
        return answer(n, node_heap_alloc_aligned(n->heap, align, bytes), bytes);
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
        return answer(n, NULL, SIZE_MAX);
    void *p = node_heap_alloc(n->heap, bytes);
    return answer(n, p == NULL ? NULL : memset(p, 0, bytes), bytes);
}

void node_free(void *p)
{
    struct node *n = node_self();
    RACES(n, freed, p, node_heap_bytes(n->heap, p));
    if (p != NULL && node_heap_release(n->heap, p) != 0)
        refuse(n, "free", p);
}

/* Size 0 frees the block, as in glibc. */
void *node_realloc(void *p, size_t bytes)
{
    struct node *n = node_self();
    if (p == NULL)
        return answer(n, node_heap_alloc(n->heap, bytes), bytes);
    if (!node_heap_owns(n->heap, p))
        refuse(n, "realloc", p);
    if (bytes > 0)
        return answer(n, node_heap_resize(n->heap, p, bytes), bytes);
    node_heap_release(n->heap, p);
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
