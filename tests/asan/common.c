/* common.c - an index behind a row is behind the whole of an array that several files may define.
 * report: global-buffer-overflow: write of 8 bytes, 16 bytes behind grid (64 bytes, */
#include <stdio.h>
#include "nx.h"

double grid[2][4], next[2][4];

static void set(long row, long column)
{
    grid[row][column] = 1; /* FAULT */
}

int main(void)
{
#ifdef CORRECT
    set(1, 3);
#else
    set(1, 6);
#endif
    printf("%g\n", grid[0][3] + next[1][0]);
    return 0;
}
