/* loop.c - the last trip of a loop writes behind a block of the heap; the block is from another function.
 * report: heap-buffer-overflow: write of 8 bytes, just behind a block of 80 bytes */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

enum { N = 10 };

static double *new_row(long n)
{
    return malloc(n * sizeof(double));
}

static void fill(double *row, long n)
{
    long i;
#ifdef CORRECT
    for (i = 0; i < n; i++)
#else
    for (i = 0; i <= n; i++)
#endif
        row[i] = i; /* FAULT */
}

int main(void)
{
    double *row = new_row(N);
    fill(row, N);
    printf("%g\n", row[N - 1]);
    free(row);
    return 0;
}
