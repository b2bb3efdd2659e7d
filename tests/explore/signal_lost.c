/* signal_lost.c - nodes 1 and 2 send node 0 a signal of a force type, for which NX keeps no message: it is
 * thrown away while no receive is posted. The handler works before it posts itself again.
 *
 * bad outcome: deadlock: node 0 waits for its second signal, which came before the handler was posted again
 * depth: 2 (first signal < second signal, second signal < the handler is posted again)      nodes: 3
 * good: the line "2 signals"
 * delay: node 1's message by more than 160 us, but not so long that it comes after the handler has been
 * posted again for node 2's: less than 600 us */
#include <stdio.h>
#include "nx.h"
#include "work.h"

enum { SIGNAL = (1 << 30) + 5, ENOUGH = 6 };
static int signals;

static void on_signal(long type, long count, long node, long pid)
{
    if (++signals == 2)
        csend(ENOUGH, NULL, 0, mynode(), 0);
    work(100);
    hrecv(SIGNAL, NULL, 0, on_signal);
}

int main(void)
{
    if (mynode() == 0) {
        hrecv(SIGNAL, NULL, 0, on_signal);
        crecv(ENOUGH, NULL, 0);
        printf("%d signals\n", signals);
    } else {
        work(mynode() == 1 ? 50 : 450);
        if (mynode() == 1)
            late(1);
        csend(SIGNAL, NULL, 0, 0, 0);
    }
    return 0;
}
