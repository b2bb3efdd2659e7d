/* local.c - a histogram has no place for the last class.
 * report: stack-buffer-overflow: read of 4 bytes, just behind counts (20 bytes, */
#include <stdio.h>
#include <string.h>
#include "nx.h"

static void count(int *counts, int value)
{
    counts[value / 20]++; /* FAULT */
}

static int largest(const int *counts, int n)
{
    int most = 0, i;
    for (i = 0; i < n; i++)
        most = counts[i] > most ? counts[i] : most;
    return most;
}

int main(void)
{
#ifdef CORRECT
    int counts[5], values[4] = {0, 99, 20, 80}, i;
#else
    int counts[5], values[4] = {0, 99, 20, 100}, i;
#endif
    memset(counts, 0, sizeof counts);
    for (i = 0; i < 4; i++)
        count(counts, values[i]);
    printf("%d\n", largest(counts, 5) > 0);
    return 0;
}
