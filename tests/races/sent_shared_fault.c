/* sent_shared_fault.c - main sends the state that the handler writes: the message may hold parts of the old
 * state and parts of the new one.
 * variable: state */
#include <stdio.h>
#include "nx.h"

enum { CHANGE = 5, STATE = 6, END = 7, N = 300 };
static long state[N], change;

static void on_change(long type, long count, long node, long pid)
{
    int i;

    for (i = 0; i < N; i++)
        state[i] += change; /* RACE */
}

int main(void)
{
    long two = 2, i;

    if (mynode() == 0) {
        hrecv(CHANGE, &change, sizeof change, on_change);
        csend(STATE, state, sizeof state, 1, 0); /* RACE */
        crecv(END, NULL, 0);
    } else {
        csend(CHANGE, &two, sizeof two, 0, 0);
        crecv(STATE, state, sizeof state);
        for (i = 0; i < N && state[i] == state[0]; i++)
            ;
        printf("%s\n", i == N ? "whole" : "torn");
        csend(END, NULL, 0, 0, 0);
    }
    return 0;
}
