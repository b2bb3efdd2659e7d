/* table.c - a function reads an element too many of a table with values; its neighbour in memory is
 * another table.
 * report: global-buffer-overflow: read of 4 bytes, just behind weights (12 bytes, */
#include <stdio.h>
#include "nx.h"

int weights[3] = {1, 2, 3}, others[3] = {4, 5, 6};

static int sum(const int *all, int n)
{
    int s = 0, i;
    for (i = 0; i < n; i++)
        s += all[i]; /* FAULT */
    return s;
}

int main(void)
{
#ifdef CORRECT
    printf("%d\n", sum(weights, 3) > 0 && sum(others, 3) == 15);
#else
    printf("%d\n", sum(weights, 4) > 0 && sum(others, 3) == 15);
#endif
    return 0;
}
