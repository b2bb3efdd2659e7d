/* table_correct.c - as table_fault.c, without its fault. */
#include <stdio.h>
#include "nx.h"

int weights[3] = {1, 2, 3}, others[3] = {4, 5, 6};

static int sum(const int *all, int n)
{
    int s = 0, i;
    for (i = 0; i < n; i++)
        s += all[i];
    return s;
}

int main(void)
{
    printf("%d\n", sum(weights, 3) > 0 && sum(others, 3) == 15);
    return 0;
}
