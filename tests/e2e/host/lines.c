/* Host: reads a line before its nodes run, and one when they have ended. */
#include "cube.h"
#include <stdio.h>

int main(void)
{
    int before = -1, after = -1;
    if (scanf("%d", &before) != 1)
        return 1;
    setpid(100);
    load("lines_node", -1, 0);
    waitcube();
    if (scanf("%d", &after) != 1)
        return 1;
    printf("host: %d and %d\n", before, after);
    return 0;
}
