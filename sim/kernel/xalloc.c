/* xalloc.c - see xalloc.h. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"

/* Not exit(): its handlers must not run on a fiber or beside running threads. dprintf() has its buffer on the
 * stack. */
noreturn void xexhausted(void)
{
    dprintf(STDERR_FILENO,
            "touchstone: the host's memory is exhausted: run with fewer nodes, or fewer runs at a "
            "time, or raise the limit (ulimit -v)\n");
    _exit(EXIT_FAILURE);
}

void *xchecked(void *made)
{
    if (!made)
        xexhausted();
    return made;
}

void *xmalloc(size_t bytes)
{
    return xchecked(malloc(bytes));
}

void *xcalloc(size_t count, size_t bytes)
{
    return xchecked(calloc(count, bytes));
}

/* glibc's realloc() to 0 bytes frees the block and returns NULL. */
void *xrealloc(void *block, size_t bytes)
{
    return xchecked(realloc(block, bytes ? bytes : 1));
}

void *xreallocarray(void *block, size_t count, size_t bytes)
{
    size_t all;
    if (__builtin_mul_overflow(count, bytes, &all))
        xexhausted();
    return xrealloc(block, all);
}

char *xstrdup(const char *text)
{
    return xchecked(strdup(text));
}

char *xstrndup(const char *text, size_t most)
{
    return xchecked(strndup(text, most));
}

void *xaligned(size_t alignment, size_t bytes)
{
    void *block;
    if (posix_memalign(&block, alignment, bytes))
        xexhausted();
    return block;
}

char *xvasprintf(const char *format, va_list list)
{
    char *text;
    if (vasprintf(&text, format, list) < 0)
        xexhausted();
    return text;
}

char *xasprintf(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    char *text = xvasprintf(format, list);
    va_end(list);
    return text;
}
