/* moved_correct.c - as moved_fault.c, without its fault. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

int main(void)
{
    int *all = malloc(10 * sizeof *all), *first = all, i;
    for (i = 0; i < 10; i++)
        all[i] = i;
    all = realloc(all, 1000 * sizeof *all);
    first = all;
    *first = 5;
    printf("%d\n", all[9]);
    free(all);
    return 0;
}
