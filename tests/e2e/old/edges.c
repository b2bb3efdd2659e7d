/* edges.c - the neighbours' values at both ends of a piece */
#include <cube.h>

extern int left, right;

edges(t, n) double *t;
{
    long from_left, from_right;

    from_left = irecv(1, t, sizeof(double));
    from_right = irecv(2, t + n + 1, sizeof(double));
    csend(1, t + n, sizeof(double), right, 0);
    csend(2, t + 1, sizeof(double), left, 0);
    msgwait(from_left);
    msgwait(from_right);
}
