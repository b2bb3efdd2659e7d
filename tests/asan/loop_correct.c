/* loop_correct.c - as loop_fault.c, without its fault. */
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
    for (i = 0; i < n; i++)
        row[i] = i;
}

int main(void)
{
    double *row = new_row(N);
    fill(row, N);
    printf("%g\n", row[N - 1]);
    free(row);
    return 0;
}
