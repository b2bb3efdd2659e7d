/* local_correct.c - as local_fault.c, without its fault. */
#include <stdio.h>
#include <string.h>
#include "nx.h"

static void count(int *counts, int value)
{
    counts[value / 20]++;
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
    int counts[5], values[4] = {0, 99, 20, 80}, i;
    memset(counts, 0, sizeof counts);
    for (i = 0; i < 4; i++)
        count(counts, values[i]);
    printf("%d\n", largest(counts, 5) > 0);
    return 0;
}
