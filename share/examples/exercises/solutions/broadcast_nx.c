/* broadcast_nx.c - exercise 3: NX's own broadcast, a send to node -1.
 *
 *    nxcc -g -O2 -o broadcast_nx broadcast_nx.c
 *    touchstone run -q -m ipsc860 -n 128 broadcast_nx */
#include <stdio.h>
#include <nx.h>

enum { NUMBERS = 1, COUNT = 1000 };

static void broadcast(double *x, long length)
{
    if (mynode() == 0)
        csend(NUMBERS, x, length, -1, 0);
    else
        crecv(NUMBERS, x, length);
}

int main(void)
{
    static double x[COUNT];
    double begin, time, work;
    int i, wrong = 0;

    for (i = 0; mynode() == 0 && i < COUNT; i++)
        x[i] = i;
    gsync();
    begin = dclock();
    broadcast(x, sizeof x);
    time = dclock() - begin;
    gdhigh(&time, 1, &work); /* that of the last node */
    for (i = 0; i < COUNT; i++)
        wrong += x[i] != i;
    if (wrong)
        printf("node %ld has %d wrong numbers\n", mynode(), wrong);
    if (mynode() == 0)
        printf("total_s %.6f\n", time);
    return 0;
}
