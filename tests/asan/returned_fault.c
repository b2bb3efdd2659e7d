/* returned_fault.c - a name is made in an array that is gone when the caller prints the name.
 * report: stack-use-after-return: read of 1 byte, where a function that has returned had its variables */
#include <stdio.h>
#include "nx.h"

static char *kept; /* so that GCC does not see what it points at */

static __attribute__((noinline)) void name_of(long node)
{
    char name[24];
    sprintf(name, "node %ld", node);
    kept = name;
}

static __attribute__((noinline)) int length(const char *s)
{
    int n = 0;
    while (s[n]) /* FAULT */
        n++;
    return n;
}

int main(void)
{
    name_of(mynode());
    printf("%d\n", length(kept));
    return 0;
}
