/* flood.c - node 0 sends more bytes than node 1 has room for; node 1 never receives. */
#include "nx.h"

static char block[1 << 20];

int main(void)
{
    int i;

    for (i = 0; mynode() == 0 && i < 40; i++)
        csend(5, block, sizeof block, 1, 0);
    if (mynode() == 1)
        crecv(6, block, sizeof block);
    return 0;
}
