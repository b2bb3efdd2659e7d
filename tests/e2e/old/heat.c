/* heat.c - heat in a rod, in pieces on a ring of nodes: C of 1989, a step in Fortran, sums by the BLAS */
#include <cube.h>
#include <stdio.h>

#define N 100
#define STEPS 50

double t[N + 2], new[N + 2];
int me, nodes, right, left;

double dasum_();

main(argc, argv) int argc;
char *argv[];
{
    int i, n = N, one = 1;
    double sum, work, c = 0.25;

    me = mynode();
    nodes = numnodes();
    right = (me + 1) % nodes;
    left = (me + nodes - 1) % nodes;
    for (i = 0; i < N + 2; i++)
        t[i] = me == 0 ? 1.0 : 0.0;
    for (i = 0; i < STEPS; i++) {
        edges(t, N);
        step_(t, new, &n, &c);
    }
    sum = dasum_(&n, t + 1, &one);
    gdsum(&sum, 1, &work);
    if (me == 0)
        printf("heat: %.6f in all after %d steps\n", sum, STEPS);
}
