/* alloca_fault.c - a line of n values has n - 1 gaps, and a place for no more.
 * report: stack-buffer-overflow: write of 8 bytes, just behind a block of alloca (40 bytes,  */
#include <alloca.h>
#include <stdio.h>
#include "nx.h"

static __attribute__((noinline)) void gaps(double *gap, const double *value, long n)
{
    long i;
    for (i = 0; i < n; i++)
        gap[i] = value[i + 1] - value[i]; /* FAULT */
}

static __attribute__((noinline)) double largest(const double *value, long n)
{
    double *gap = alloca((n - 1) * sizeof *gap), most = 0;
    long i;
    gaps(gap, value, n);
    for (i = 0; i < n - 1; i++)
        most = gap[i] > most ? gap[i] : most;
    return most;
}

int main(void)
{
    double value[7] = {0, 1, 3, 6, 7, 7, 9};
    printf("%g\n", largest(value, 5 + numnodes()));
    return 0;
}
