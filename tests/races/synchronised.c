/* synchronised.c - node 0 fills its table after gsync, when the other nodes may already ask for it: gsync
 * orders only what comes before it.
 * With CORRECT: node 0 fills its table before gsync, and the other nodes ask for it after gsync: the
 * handler runs when the table is full.
 * variable: table
 * run: -n 3 */
#include <stdio.h>
#include "nx.h"

enum { ASK = 5, ANSWER = 6, END = 7, N = 20 };
static long table[N], asked;

static void on_ask(long type, long count, long node, long pid)
{
    long sum = table[asked] + table[N - 1]; /* RACE */

    hrecv(ASK, &asked, sizeof asked, on_ask);
    csend(ANSWER, &sum, sizeof sum, node, 0);
}

int main(void)
{
    long i, me = mynode(), sum;

    if (me == 0) {
        hrecv(ASK, &asked, sizeof asked, on_ask);
#ifndef CORRECT
        gsync();
#endif
        for (i = 0; i < N; i++)
            table[i] = 10 * i; /* RACE */
#ifdef CORRECT
        gsync();
#endif
        for (i = 1; i < numnodes(); i++)
            crecv(END, NULL, 0);
    } else {
        gsync();
        csendrecv(ASK, &me, sizeof me, 0, 0, ANSWER, &sum, sizeof sum);
        if (me == 1)
            printf("%ld\n", sum);
        csend(END, NULL, 0, 0, 0);
    }
    return 0;
}
