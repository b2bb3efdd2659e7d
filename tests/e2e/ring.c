/* ring.c - a token travels round a ring of nodes, and grows. */
#include <stdio.h>
#include "nx.h"

static char token[4096];

int main(void)
{
    long me = mynode(), n = numnodes(), lap, length;

    for (lap = 1; lap <= 12; lap++) {
        length = 1L << lap; /* short, long and in between */
        if (me == 0)
            csend(lap, token, length, (me + 1) % n, 0);
        crecv(lap, token, sizeof token);
        if (me != 0)
            csend(lap, token, length, (me + 1) % n, 0);
    }
    if (me == 0)
        printf("%ld laps of %ld nodes, %.9f s\n", lap - 1, n, dclock());
    return 0;
}
