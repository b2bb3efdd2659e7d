/* jacobi.c - heat in a square plate, by Jacobi's method, as such programs were written for the iPSC/860
 * about 1990. doc/tutorial.md takes it from here to a study.
 *
 *    nxcc -w -g -O2 -o jacobi jacobi.c
 *    touchstone run -m ipsc860 -n 16 jacobi
 *
 * The plate is N x N points; its upper edge is hot. Each node has a strip of rows, and a copy of the rows
 * above and below. Strips that are neighbours lie on nodes that are neighbours in the cube: gray and ginv. */
#include <stdio.h>
#include <cube.h>

#define N 256
#define STEPS 100
#define UP 1 /* types of messages: a row for the strip above, ... */
#define DOWN 2
#define ROW (N * sizeof(double))

double t[N + 2][N], new[N + 2][N];
double change, work;
int me, nodes, above, below, rows;

double fabs();

/* Sends the first and the last row of the strip, and receives those of the neighbours. */
exchange()
{
    if (me > 0)
        csend(UP, t[1], ROW, above, 0);
    if (me < nodes - 1)
        csend(DOWN, t[rows], ROW, below, 0);
    if (me < nodes - 1)
        crecv(UP, t[rows + 1], ROW);
    if (me > 0)
        crecv(DOWN, t[0], ROW);
}

/* Computes the new temperatures of some rows, and the largest change. */
sweep(from, to)
{
    register int i, j;
    double d;

    for (i = from; i <= to; i++)
        for (j = 1; j < N - 1; j++) {
            new[i][j] = 0.25 * (t[i - 1][j] + t[i + 1][j] + t[i][j - 1] + t[i][j + 1]);
            d = fabs(new[i][j] - t[i][j]);
            if (d > change)
                change = d;
        }
}

copy()
{
    register int i, j;

    for (i = 1; i <= rows; i++)
        for (j = 1; j < N - 1; j++)
            t[i][j] = new[i][j];
}

main()
{
    int step, j;
    double begin;

    nodes = numnodes();
    me = ginv(mynode()); /* the number of the strip */
    above = gray(me - 1);
    below = gray(me + 1);
    rows = N / nodes;
    if (me == 0)
        for (j = 0; j < N; j++)
            t[0][j] = 100.0;

    gsync();
    begin = dclock();
    for (step = 0; step < STEPS; step++) {
        exchange();
        change = 0.0;
        sweep(1, rows);
        copy();
        gdhigh(&change, 1L, &work);
    }
    if (mynode() == 0)
        printf("change %.6f\ntotal_s %.6f\n", change, dclock() - begin);
}
