/* common_correct.c - as common_fault.c, without its fault. */
#include <stdio.h>
#include "nx.h"

double grid[2][4], next[2][4];

static void set(long row, long column)
{
    grid[row][column] = 1;
}

int main(void)
{
    set(1, 3);
    printf("%g\n", grid[0][3] + next[1][0]);
    return 0;
}
