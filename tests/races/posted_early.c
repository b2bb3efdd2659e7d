/* posted_early.c - the handler is posted before the table that it looks into is filled. In the usual run
 * the first message comes later.
 * With CORRECT: the handler is posted after the table that it looks into is filled: hrecv comes between
 * the last store and the first run.
 * variable: square */
#include <stdio.h>
#include "nx.h"

enum { ASK = 5, ANSWER = 6, END = 7 };
static long square[10], asked;

static void on_ask(long type, long count, long node, long pid)
{
    csend(ANSWER, &square[asked], sizeof square[asked], node, 0); /* RACE */
}

int main(void)
{
    long i, answer, what = 7;

    if (mynode() == 0) {
#ifndef CORRECT
        hrecv(ASK, &asked, sizeof asked, on_ask);
#endif
        for (i = 0; i < 10; i++)
            square[i] = i * i; /* RACE */
#ifdef CORRECT
        hrecv(ASK, &asked, sizeof asked, on_ask);
#endif
        crecv(END, NULL, 0);
    } else {
        csendrecv(ASK, &what, sizeof what, 0, 0, ANSWER, &answer, sizeof answer);
        csend(END, NULL, 0, 0, 0);
        printf("%ld\n", answer);
    }
    return 0;
}
