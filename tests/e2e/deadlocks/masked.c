/* masked.c - node 0 masks its handler and waits for what only that would bring about. */
#include "nx.h"

static char in[8];

static void answer(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)pid;
    csend(6, in, sizeof in, node, 0);
}

int main(void)
{
    char buf[8] = "";

    if (mynode() == 0) {
        masktrap(1); /* first: on MPI the message may be here already */
        hrecv(5, in, sizeof in, answer);
        crecv(9, buf, sizeof buf);
        masktrap(0);
    } else {
        csendrecv(5, buf, sizeof buf, 0, 0, 6, buf, sizeof buf);
        csend(9, buf, sizeof buf, 0, 0);
    }
    return 0;
}
