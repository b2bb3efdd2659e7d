/* sent_shared.c - main sends the state that the handler writes: the message may hold parts of the old
 * state and parts of the new one.
 * With CORRECT: the handler is masked until csend returns, when the buffer may be used again.
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
#ifdef CORRECT
        masktrap(1);
        csend(STATE, state, sizeof state, 1, 0);
        masktrap(0);
#else
        csend(STATE, state, sizeof state, 1, 0); /* RACE */
#endif
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
