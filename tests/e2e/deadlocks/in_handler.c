/* in_handler.c - a handler waits for what another handler would bring about. */
#include "nx.h"

static char in[8], in_too[8];

static void second(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)pid;
    csend(9, in_too, sizeof in_too, node, 0);
}

static void first(long type, long count, long node, long pid)
{
    char buf[8];

    (void)type, (void)count, (void)node, (void)pid;
    crecv(7, buf, sizeof buf);
}

int main(void)
{
    char buf[8] = "";

    if (mynode() == 0) {
        masktrap(1); /* on MPI both messages may be here already: both are posted before either runs */
        hrecv(5, in, sizeof in, first);
        hrecv(6, in_too, sizeof in_too, second);
        masktrap(0);
        crecv(8, buf, sizeof buf);
    } else {
        csend(5, buf, sizeof buf, 0, 0);
        csendrecv(6, buf, sizeof buf, 0, 0, 9, buf, sizeof buf);
        csend(7, buf, sizeof buf, 0, 0);
        csend(8, buf, sizeof buf, 0, 0);
    }
    return 0;
}
