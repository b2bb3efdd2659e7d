/* volatile_count_correct.c - the handler alone counts down a volatile variable; main reads it until it is
 * 0, a word that is loaded in one step. */
#include <stdio.h>
#include "nx.h"

enum { CLOSE = 5, NODES = 4 };
static volatile long running = NODES - 1;

static void on_close(long type, long count, long node, long pid)
{
    running--;
    hrecv(CLOSE, NULL, 0, on_close);
}

int main(void)
{
    int i;

    if (mynode() == 0) {
        hrecv(CLOSE, NULL, 0, on_close);
        while (running > 0)
            flick();
        printf("all closed\n");
    } else {
        for (i = 1; i < NODES; i++)
            csend(CLOSE, NULL, 0, 0, 0);
    }
    return 0;
}
