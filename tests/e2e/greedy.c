/* greedy.c - takes all memory of its node, which is less than the host's; with an argument, it ignores that
 * malloc returns NULL. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"

int main(int argc, char **argv)
{
    int careless = argc > 1 && !strcmp(argv[1], "careless");
    long got;
    char *p;

    for (got = 0; (p = malloc(65536)) || careless; got++)
        p[0] = 1;
    if (mynode() == 0)
        printf("%ld MB\n", got / 16);
    return 0;
}
