/* quits.c - node 1 exits with a status; the other nodes continue. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

int main(void)
{
    if (mynode() == 1)
        exit(3);
    printf("node %ld is done\n", mynode());
    return 0;
}
