/* cycle.c - each node waits for its neighbour's message before it sends its own. */
#include "nx.h"

static void exchange(long from, long to)
{
    char in[8], out[8] = "";
    long info[8];

    crecvx(7, in, sizeof in, from, -1, info);
    csend(7, out, sizeof out, to, 0);
}

int main(void)
{
    long nodes = numnodes();

    exchange((mynode() + 1) % nodes, (mynode() + nodes - 1) % nodes);
    return 0;
}
