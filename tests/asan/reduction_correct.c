/* reduction_correct.c - as reduction_fault.c, without its fault.
 * run: -n 2 */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

enum { N = 10 };

int main(void)
{
    double x[N], *work = malloc(N * sizeof(double));
    int i;
    for (i = 0; i < N; i++)
        x[i] = i;
    gdsum(x, N, work);
    if (mynode() == 0)
        printf("%g\n", x[2]);
    free(work);
    return 0;
}
