/* deadlock.c - a wavefront that never starts: every node waits for its left neighbour.
 *
 *    nxcc -g -O2 -o deadlock deadlock.c
 *    touchstone run -n 4 deadlock
 *
 * Each node owns a strip of columns. In each step it needs the border of the node to its left, computes
 * its strip, and gives its own border to the node to its right. As long as node 0 was the left edge of the
 * domain, it began at once, and the others followed. Then somebody made the domain periodic: node 0 got a
 * left neighbour, the last node, and waits for it, too.
 *
 * The remedy: all send the borders of the step before first, and receive then. csend returns when the
 * buffer may be used again, whether the receiver waits or not. */
#include <stdio.h>
#include <nx.h>

enum { BORDER = 7, ROWS = 64, STEPS = 10 };

static double border[ROWS], strip[ROWS];

static void compute(void)
{
    int row;

    for (row = 0; row < ROWS; row++)
        strip[row] = 0.5 * (strip[row] + border[row]);
}

int main(void)
{
    long right = (mynode() + 1) % numnodes(), left = (mynode() + numnodes() - 1) % numnodes(), info[8];
    int step;

    for (step = 0; step < STEPS; step++) {
        crecvx(BORDER, border, sizeof border, left, -1, info); /* it has not sent one yet */
        compute();
        csend(BORDER, strip, sizeof strip, right, 0);
    }
    if (mynode() == 0)
        printf("%d steps on %ld nodes\n", STEPS, numnodes());
    return 0;
}
