/* before.c - a search from behind does not stop at the beginning of a block.
 * report: heap-buffer-overflow: read of 4 bytes, 4 bytes before a block of 400 bytes */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

enum { N = 100 };

static int last_of(const int *all, int wanted)
{
    int i = N - 1;
#ifdef CORRECT
    while (i >= 0 && all[i] != wanted)
#else
    while (all[i] != wanted) /* FAULT */
#endif
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
