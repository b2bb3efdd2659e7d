/* volatile_count.c - main and the handler both count down a volatile variable: volatile does not make
 * load and store one step, so a count may be lost.
 * With CORRECT: the handler alone counts down a volatile variable; main reads it until it is 0, a word
 * that is loaded in one step.
 * variable: running */
#include <stdio.h>
#include "nx.h"

enum { CLOSE = 5, NODES = 4 };
#ifdef CORRECT
static volatile long running = NODES - 1;
#else
static volatile long running = NODES;
#endif

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
#ifndef CORRECT
        running--; /* RACE */
#endif
        while (running > 0)
            flick();
        printf("all closed\n");
    } else {
        for (i = 1; i < NODES; i++)
            csend(CLOSE, NULL, 0, 0, 0);
    }
    return 0;
}
