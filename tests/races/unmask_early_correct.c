/* unmask_early_correct.c - main lets handlers run only when both `sum` and `samples` have been updated, so
 * that the average that the handler computes from them is of whole samples. */
#include <stdio.h>
#include "nx.h"

enum { ASK = 5, ANSWER = 6, END = 7 };
static double sum = 2;
static long samples = 1;

static void on_ask(long type, long count, long node, long pid)
{
    double average = sum / samples;

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
            samples++;
            masktrap(0);
        }
        crecv(END, NULL, 0);
    } else {
        csendrecv(ASK, NULL, 0, 0, 0, ANSWER, &average, sizeof average);
        csend(END, NULL, 0, 0, 0);
        printf("average %.3f\n", average);
    }
    return 0;
}
