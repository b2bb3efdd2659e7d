/* gdb.c - rows of a grid relax; each node gets its neighbour's row. Run in a debugger (gdb.sh). */
#include <stdio.h>
#include "nx.h"

enum { WIDTH = 64, ROUNDS = 6, SWEEPS = 20 };
extern long rounds_done; /* gdb_part.c */
static double row[WIDTH];
long me;

static double relax(double *cell, int width, long round)
{
    double change = 0;
    int sweep, i;

    cell[0] = (double)(1000 * me + round);
    for (sweep = 0; sweep < SWEEPS; sweep++)
        for (i = 1; i < width - 1; i++) {
            double next = (cell[i - 1] + cell[i + 1]) / 2;
            change += next > cell[i] ? next - cell[i] : cell[i] - next;
            cell[i] = next;
        }
    return change;
}

int main(void)
{
    long round, nodes = numnodes();
    double began, change = 0;

    me = mynode();
    for (round = 1; round <= ROUNDS; round++) {
        began = dclock();
        csend(round, row, sizeof row, (me + 1) % nodes, 0);
        crecv(round, row, sizeof row);
        change = relax(row, WIDTH, round);
        rounds_done = round; /* one more */
    }
    printf("node %ld: %g, %d\n", me, change, began > 0);
    return 0;
}
