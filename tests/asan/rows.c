/* rows.c - an array of variable size is for its own row; the row above is one longer.
 * report: stack-buffer-overflow: write of 1 byte, just behind an array of variable size (5 bytes, */
#include <stdio.h>
#include "nx.h"

static __attribute__((noinline)) void set(char *row, long n)
{
    long i;
#ifdef CORRECT
    for (i = 0; i < n; i++)
#else
    for (i = 0; i <= n; i++)
#endif
        row[i] = (char)i; /* FAULT */
}

int main(void)
{
    long n = 4 + numnodes(), s = 0;
    char row[n];
    set(row, n);
    while (n-- > 0)
        s += row[n];
    printf("%ld\n", s);
    return 0;
}
