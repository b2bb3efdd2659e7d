/* xalloc.h - memory of the host, for the simulator itself. None of these functions returns without memory:
 * they write to standard error that the host's memory is exhausted and end the process with status 1.
 * Callable from any thread and any fiber. The caller frees what it gets with free(). (What a simulated node
 * allocates is counted against the node and may run out: guest programs get NULL from their own heap, never
 * from here.) */
#ifndef KERNEL_XALLOC_H
#define KERNEL_XALLOC_H
#include <stdarg.h>
#include <stddef.h>
#include <stdnoreturn.h>

/* As malloc, calloc, reallocarray, strdup and strndup; of 0 bytes a block that can be freed. */
void *xmalloc(size_t bytes);
void *xcalloc(size_t count, size_t bytes);
void *xrealloc(void *block, size_t bytes);
void *xreallocarray(void *block, size_t count, size_t bytes);
char *xstrdup(const char *text);
char *xstrndup(const char *text, size_t most);
/* Room for one more behind `count` items of a list that this function alone makes grow: the room is a power
 * of two, so that nobody has to keep it. */
static inline void *xgrown(void *list, size_t count, size_t bytes)
{
    return count & (count - 1) ? list : xreallocarray(list, count ? 2 * count : 1, bytes);
}
/* As posix_memalign: alignment is a power of two, at least sizeof(void *). */
void *xaligned(size_t alignment, size_t bytes);

/* A new string, formatted as by printf. */
char *xasprintf(const char *format, ...) __attribute__((format(printf, 1, 2)));
char *xvasprintf(const char *format, va_list list) __attribute__((format(printf, 1, 0)));

/* Returns what a library has just allocated (jansson, libevent, open_memstream); ends the process if it is
 * NULL. */
void *xchecked(void *made);
/* For libraries that report the lack of memory otherwise. */
noreturn void xexhausted(void);
#endif
