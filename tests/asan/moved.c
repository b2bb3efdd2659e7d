/* moved.c - realloc moves a block, and a pointer into the old one is still used.
 * report: heap-use-after-free: write of 4 bytes, 0 bytes into a block of 40 bytes */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

int main(void)
{
    int *all = malloc(10 * sizeof *all), *first = all, i;
    for (i = 0; i < 10; i++)
        all[i] = i;
    all = realloc(all, 1000 * sizeof *all);
#ifdef CORRECT
    first = all;
#endif
    *first = 5; /* FAULT */
    printf("%d\n", all[9]);
    free(all);
    return 0;
}
