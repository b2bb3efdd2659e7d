/* jacobi_faster.c - jacobi.c, improved as doc/tutorial.md tells: a strip's inner rows are computed while
 * the messages are under way, and the nodes agree on the change at every 10th step only.
 *
 *    nxcc -w -g -O2 -o jacobi_faster jacobi_faster.c
 *    touchstone run -m ipsc860 -n 16 jacobi_faster
 *
 * The plate is N x N points; its upper edge is hot. Each node has a strip of rows, and a copy of the rows
 * above and below. Strips that are neighbours lie on nodes that are neighbours in the cube: gray and ginv. */
#include <stdio.h>
#include <cube.h>

#define N 256
#define STEPS 100
#define EVERY 10
#define UP 1 /* types of messages: a row for the strip above, ... */
#define DOWN 2
#define ROW (N * sizeof(double))

double t[N + 2][N], new[N + 2][N];
double change, work;
int me, nodes, above, below, rows;

double fabs();

long posted[4], count; /* the messages under way */

/* Asks for the neighbours' rows, and begins to send them the first and the last row of the strip. */
begin_exchange()
{
    count = 0;
    if (me > 0)
        posted[count++] = irecv(DOWN, t[0], ROW);
    if (me < nodes - 1)
        posted[count++] = irecv(UP, t[rows + 1], ROW);
    if (me > 0)
        posted[count++] = isend(UP, t[1], ROW, above, 0);
    if (me < nodes - 1)
        posted[count++] = isend(DOWN, t[rows], ROW, below, 0);
}

end_exchange()
{
    while (count > 0)
        msgwait(posted[--count]);
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
        begin_exchange();
        change = 0.0;
        sweep(2, rows - 1);
        end_exchange();
        sweep(1, 1);
        if (rows > 1)
            sweep(rows, rows);
        copy();
        if (step % EVERY == EVERY - 1)
            gdhigh(&change, 1L, &work);
    }
    if (mynode() == 0)
        printf("change %.6f\ntotal_s %.6f\n", change, dclock() - begin);
}
