/* interrupted.c - node 1 computes while node 0 interrupts it again and again; prints the sum of the
 * interrupts' times. */
#include <stdio.h>
#include "nx.h"

enum { TIMES = 100 };

static volatile long got;
static double sum;

static void handler(long type, long count, long node, long pid)
{
    (void)count, (void)node, (void)pid;
    got++;
    sum += dclock();
    hrecv(type, NULL, 0, handler);
}

int main(void)
{
    volatile double x = 1;
    hrecv(5, NULL, 0, handler);
    gsync();
    for (int i = 0; i < TIMES && mynode() == 0; i++) {
        for (int k = 0; k < 100 + 37 * i; k++)
            x = x * 0.99 + 1;
        csend(5, NULL, 0, 1, 0);
    }
    while (mynode() == 1 && got < TIMES)
        x = x * 0.99 + 1;
    if (mynode() == 1)
        printf("%.9f\n", sum);
    return 0;
}
