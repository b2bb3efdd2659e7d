/* own_memory.c - see own_memory.h. */
#include "guest/libc/own_memory.h"
#include <stdlib.h>
#include <string.h>
#include "guest/libc/libc_parts.h"
#include "guest/span.h"
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "node/node.h"
#include "node/self.h"
#include "node/system.h"
#include "nx_api/contract/backend.h"

enum {
    LINE = 64, /* the stack's top is at a multiple of a cache line */
    ALIGN = 16,
    PAGE = 4096,
    MOST = 512 << 10,
    LIST_ENDS = 2, /* the second NULL is an empty environment */
};

static size_t round_up(size_t bytes, size_t to)
{
    return (bytes + to - 1) / to * to;
}

/* --- arguments --- */

size_t own_arguments_bytes(int argc, char *const *argv)
{
    size_t bytes = sizeof(struct crossing_top) + ((size_t)argc + LIST_ENDS) * sizeof *argv;
    for (int i = 0; i < argc; i++)
        bytes += strlen(argv[i]) + 1;
    return round_up(bytes, LINE);
}

void own_put_arguments(struct node *n, int argc, char *const *argv)
{
    n->cold->argc = argc;
    n->cold->argv = (char **)(n->guest.stack + n->guest.stack_bytes + sizeof(struct crossing_top));
    char *text = (char *)(n->cold->argv + argc + LIST_ENDS);
    for (int i = 0; i < argc; i++) {
        n->cold->argv[i] = text;
        text = stpcpy(text, argv[i]) + 1;
    }
}

/* --- at the end of the heap --- */

size_t own_memory_bytes(const struct node *n)
{
    size_t stack = n->sys->cfg->stack_bytes / PAGE * PAGE;
    return stack < MOST ? stack : MOST;
}

void *own_memory_take(struct node *n, size_t bytes)
{
    struct own_memory *own = &libc_of(n)->own;
    if (!own->next) {
        span_guard_heap(n);
        own->end = n->guest.heap_start + n->guest.region->heap_bytes;
        own->next = own->end - own_memory_bytes(n);
    }
    bytes = round_up(bytes, ALIGN);
    if (bytes > (size_t)(own->end - own->next))
        return NULL;
    own->next += bytes;
    return own->next - bytes;
}

void *own_memory_need(struct node *n, size_t bytes)
{
    void *at = own_memory_take(n, bytes);
    if (!at)
        node_fail(n, "the environment, and what the C library answers with, take more than %zu KB",
                  own_memory_bytes(n) >> 10);
    return at;
}

char *own_memory_text(struct node *n, const char *text)
{
    struct own_memory *own = &libc_of(n)->own;
    for (size_t i = 0; i < own->text_count; i++)
        if (strcmp(own->texts[i], text) == 0)
            return own->texts[i];
    char *copy = own_memory_need(n, strlen(text) + 1);
    own->texts = xreallocarray(own->texts, own->text_count + 1, sizeof *own->texts);
    return own->texts[own->text_count++] = strcpy(copy, text);
}

void own_memory_forget(struct own_memory *own)
{
    free(own->texts);
}
