/* volatile_count_fault.c - main and the handler both count down a volatile variable: volatile does not make
 * load and store one step, so a count may be lost.
 * variable: running */
#include <stdio.h>
#include "nx.h"

enum { CLOSE = 5, NODES = 4 };
static volatile long running = NODES;

static void on_close(long type, long count, long node, long pid)
{
    running--; /* RACE */
    hrecv(CLOSE, NULL, 0, on_close);
}

int main(void)
{
    int i;

    if (mynode() == 0) {
        hrecv(CLOSE, NULL, 0, on_close);
        running--; /* RACE */
        while (running > 0)
            flick();
        printf("all closed\n");
    } else {
        for (i = 1; i < NODES; i++)
            csend(CLOSE, NULL, 0, 0, 0);
    }
    return 0;
}
