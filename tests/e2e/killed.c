/* killed.c - computes for a while and passes a message round; its arguments only change the time. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

int main(int argc, char **argv)
{
    volatile double x = 1;
    char b[1] = {0};
    long me = mynode(), all = numnodes(), steps = argc > 1 ? atol(argv[1]) : 1;
    for (long i = 0; i < 20000 * steps; i++)
        x = x * 0.5 + 1;
    if (me > 0)
        csend(1, b, 1, 0, 0);
    for (long i = 1; me == 0 && i < all; i++) {
        crecv(1, b, 1);
        printf("from %ld\n", infonode());
    }
    if (me == 0)
        printf("x %g\ntotal_s %.9f\n", x, dclock());
    return 0;
}
