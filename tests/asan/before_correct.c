/* before_correct.c - as before_fault.c, without its fault. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

enum { N = 100 };

static int last_of(const int *all, int wanted)
{
    int i = N - 1;
    while (i >= 0 && all[i] != wanted)
        i--;
    return i;
}

int main(void)
{
    int *all = calloc(N, sizeof *all);
    printf("%d\n", last_of(all, 5) < 0);
    free(all);
    return 0;
}
