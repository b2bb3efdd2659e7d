/* later_memory.c - memory of malloc's, by later names; and random bytes, whose state is the node's. */
#define _GNU_SOURCE
#include <errno.h>
#include <malloc.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <unistd.h>
#include <wchar.h>

void *reallocarray(void *p, size_t count, size_t bytes)
{
    size_t all;
    if (!__builtin_mul_overflow(count, bytes, &all))
        return realloc(p, all);
    errno = ENOMEM;
    return NULL;
}

wchar_t *wcsdup(const wchar_t *text)
{
    size_t length = wcslen(text) + 1;
    wchar_t *copy = malloc(length * sizeof *copy);
    return copy ? wmemcpy(copy, text, length) : NULL;
}

struct mallinfo whole_numbers(void) __asm__("mallinfo"); /* which glibc would have nobody call */

struct mallinfo2 mallinfo2(void)
{
    struct mallinfo m = whole_numbers();
    return (struct mallinfo2){.arena = (unsigned)m.arena,
                              .ordblks = (unsigned)m.ordblks,
                              .uordblks = (unsigned)m.uordblks,
                              .fordblks = (unsigned)m.fordblks};
}

/* A node's malloc has nothing to be set. */
int mallopt(int what, int value)
{
    (void)what, (void)value;
    return 1;
}

ssize_t getrandom(void *to, size_t bytes, unsigned flags)
{
    (void)flags;
    return getentropy(to, bytes) ? -1 : (ssize_t)bytes;
}
