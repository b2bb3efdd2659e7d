/* broadcast.c - exercise 3: node 0 has 1,000 numbers that all nodes need.
 *
 *    nxcc -g -O2 -o broadcast broadcast.c
 *    touchstone run -q -m ipsc860 -n 32 broadcast
 *
 * Here node 0 sends them to each of the others, one after the other. Write something better into
 * broadcast(). */
#include <stdio.h>
#include <nx.h>

enum { NUMBERS = 1, COUNT = 1000 };

static void broadcast(double *x, long length)
{
    long i;

    if (mynode() > 0)
        crecv(NUMBERS, x, length);
    for (i = 1; mynode() == 0 && i < numnodes(); i++)
        csend(NUMBERS, x, length, i, 0);
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
