/* broadcast_tree.c - a solution of exercise 3: who has the numbers helps to send them.
 *
 *    nxcc -g -O2 -o broadcast_tree broadcast_tree.c
 *    touchstone run -q -m ipsc860 -n 32 broadcast_tree
 *
 * In round k, nodes 0 to 2^k - 1 have the numbers, and node i sends them to node i + 2^k. On a hypercube
 * these two are neighbours. */
#include <stdio.h>
#include <nx.h>

enum { NUMBERS = 1, COUNT = 1000 };

static void broadcast(double *x, long length)
{
    long have;

    for (have = 1; have < numnodes(); have *= 2) {
        if (mynode() < have && mynode() + have < numnodes())
            csend(NUMBERS, x, length, mynode() + have, 0);
        if (mynode() >= have && mynode() < 2 * have)
            crecv(NUMBERS, x, length);
    }
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
