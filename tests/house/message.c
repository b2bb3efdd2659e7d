/* message.c - a message from node 0 to node 1, which waits for it: what tests/house/measure follows. Both
 * nodes compute for a while behind it, so that nothing else happens meanwhile. */
#include "nx.h"

static void compute(void)
{
    for (volatile long i = 0; i < 500; i++)
        ;
}

int main(void)
{
    long number = 0;
    if (mynode() == 1) {
        crecv(1, &number, sizeof number);
    } else {
        compute();
        csend(1, &number, sizeof number, 1, 0);
    }
    compute();
    return 0;
}
