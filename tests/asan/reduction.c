/* reduction.c - gdsum gets too little room to work in.
 * report: heap-buffer-overflow: write of 80 bytes, the last 40 of them just behind a block of 40 bytes
 * run: -n 2 */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

enum { N = 10 };

int main(void)
{
#ifdef CORRECT
    double x[N], *work = malloc(N * sizeof(double));
#else
    double x[N], *work = malloc(N * sizeof(float));
#endif
    int i;
    for (i = 0; i < N; i++)
        x[i] = i;
    gdsum(x, N, work); /* FAULT */
    if (mynode() == 0)
        printf("%g\n", x[2]);
    free(work);
    return 0;
}
