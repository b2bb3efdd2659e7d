/* parts.c - for the test of fitting: messages to and fro, and messages that interrupt a computation, so many
 * of each. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

static volatile double sum;
static volatile long left;

static void interrupted(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    --left;
}

static void to_and_fro(long times)
{
    long other = 1 - mynode(), word = 0;

    for (; times > 0; times--) {
        if (mynode() == 0)
            csend(1, (char *)&word, sizeof word, other, 0);
        crecv(1, (char *)&word, sizeof word);
        if (mynode() == 1)
            csend(1, (char *)&word, sizeof word, other, 0);
    }
}

static void compute(long steps)
{
    for (; steps > 0; steps--)
        sum += 1.0 / (double)steps;
}

/* Node 1 computes for as long as it takes node 0 to interrupt it so often. */
static void interrupt(long times)
{
    char word[8];

    for (left = times; times > 0; times--) {
        if (mynode() == 1)
            hrecv(2, word, sizeof word, interrupted);
        gsync();
        if (mynode() == 0)
            csend(2, word, sizeof word, 1, 0);
        compute(2000);
        gsync();
    }
}

int main(int argc, char **argv)
{
    long messages = argc > 1 ? atol(argv[1]) : 100, interrupts = argc > 2 ? atol(argv[2]) : 0;
    double begun = dclock();

    to_and_fro(messages);
    interrupt(interrupts);
    if (mynode() == 1)
        printf("total_s %.9f\nleft %ld\n", dclock() - begun, left);
    return 0;
}
