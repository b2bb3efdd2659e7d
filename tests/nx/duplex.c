/* Two nodes that send each other long messages at the same time take no longer than one that sends alone: a
 * channel has both directions, and a sending node answers the other node's request to send meanwhile. (On the
 * Paragon of early 1994 they take turns: tests/net/test_protocol.c.)
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 * run: -m paragon95 -n 2
 */
#include <nx.h>
#include <stdio.h>

enum { SYNC = 1, DATA, BYTES = 100000 };
static char in[BYTES], out[BYTES];

static double exchange(int both)
{
    long id = irecv(DATA, in, BYTES), other = 1 - mynode();
    double begin;
    csend(SYNC, NULL, 0, other, 0);
    crecv(SYNC, NULL, 0);
    begin = dclock();
    if (both || mynode() == 0)
        csend(DATA, out, BYTES, other, 0);
    if (both || mynode() == 1)
        msgwait(id);
    else
        msgcancel(id);
    return dclock() - begin;
}

int main(void)
{
    double one = exchange(0), two;
    gsync();
    two = exchange(1);
    printf("%s\n", two < 1.03 * one ? "at once" : "in turn");
    return 0;
}
