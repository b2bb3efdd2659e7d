/* quits.c - node 1 exits with a status; the other nodes continue. With an argument, the node says why before,
 * on standard error without an end of the line; with two, all do, and none exits. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

int main(int argc, char **argv)
{
    (void)argv;
    if (argc > 2 || (argc > 1 && mynode() == 1))
        fprintf(stderr, "no input");
    if (argc < 3 && mynode() == 1)
        exit(3);
    printf("node %ld is done\n", mynode());
    return 0;
}
