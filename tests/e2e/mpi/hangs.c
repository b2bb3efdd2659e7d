/* Nodes that compute, wait and have ended, for ever. */
#include <nx.h>
#include <stdio.h>

int main(void)
{
    static volatile long forever = 1;
    printf("%ld\n", mynode());
    fflush(stdout);
    if (mynode() == 1)
        crecv(12, 0, 0);
    while (mynode() == 0 && forever)
        ;
    return 0;
}
