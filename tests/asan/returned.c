/* returned.c - a name is made in an array that is gone when the caller prints the name.
 * With CORRECT: frames lie where others have been, with variables that have red zones and with arguments
 * that have none.
 * report: stack-use-after-return: read of 1 byte, where a function that has returned had its variables */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "nx.h"

#ifdef CORRECT
static __attribute__((noinline)) void name_of(char *name, long node)
{
    char own[24];
    sprintf(own, "node %ld", node);
    strcpy(name, own);
}
#else
static char *kept; /* so that GCC does not see what it points at */

static __attribute__((noinline)) void name_of(long node)
{
    char name[24];
    sprintf(name, "node %ld", node);
    kept = name;
}
#endif

static __attribute__((noinline)) int length(const char *s)
{
    int n = 0;
    while (s[n]) /* FAULT */
        n++;
    return n;
}

#ifdef CORRECT
struct large {
    long all[40];
};

static __attribute__((noinline)) long last_of(struct large l, int at)
{
    const long *p = l.all;
    return p[at];
}

static __attribute__((noinline)) long sum(int count, ...)
{
    long s = 0;
    va_list all;
    va_start(all, count);
    while (count-- > 0)
        s += va_arg(all, long);
    va_end(all);
    return s;
}

static __attribute__((noinline)) long deep(int levels)
{
    long own[9], *p = own;
    int i;
    for (i = 0; i < 9; i++)
        p[i] = i;
    return levels > 0 ? deep(levels - 1) + p[levels % 9] : 0;
}
#endif

int main(void)
{
#ifdef CORRECT
    struct large l = {{1, 2, 3}};
    char name[24];
    long s;
    name_of(name, mynode());
    s = length(name) + deep(30);
    s += last_of(l, 2) + sum(9, 1L, 2L, 3L, 4L, 5L, 6L, 7L, 8L, 9L) + deep(3);
    printf("%ld\n", s);
#else
    name_of(mynode());
    printf("%d\n", length(kept));
#endif
    return 0;
}
