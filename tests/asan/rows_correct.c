/* rows_correct.c - as rows_fault.c, without its fault. */
#include <stdio.h>
#include "nx.h"

static __attribute__((noinline)) void set(char *row, long n)
{
    long i;
    for (i = 0; i < n; i++)
        row[i] = (char)i;
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
