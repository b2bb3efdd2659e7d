/* unmask_early.c - main lets handlers run before its second update: the average that the handler computes
 * from `sum` and `samples` may miss a sample's other half.
 * With CORRECT: main lets handlers run only when both have been updated.
 * variable: samples */
#include <stdio.h>
#include "nx.h"

enum { ASK = 5, ANSWER = 6, END = 7 };
static double sum = 2;
static long samples = 1;

static void on_ask(long type, long count, long node, long pid)
{
    double average = sum / samples; /* RACE */

    csend(ANSWER, &average, sizeof average, node, 0);
}

int main(void)
{
    double average = 0;
    int i;

    if (mynode() == 0) {
        hrecv(ASK, NULL, 0, on_ask);
        for (i = 0; i < 4; i++) {
            masktrap(1);
            sum += 2;
#ifdef CORRECT
            samples++;
            masktrap(0);
#else
            masktrap(0);
            samples++; /* RACE */
#endif
        }
        crecv(END, NULL, 0);
    } else {
        csendrecv(ASK, NULL, 0, 0, 0, ANSWER, &average, sizeof average);
        csend(END, NULL, 0, 0, 0);
        printf("average %.3f\n", average);
    }
    return 0;
}
