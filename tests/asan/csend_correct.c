/* csend_correct.c - as csend_fault.c, without its fault.
 * run: -n 2 */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

enum { N = 20 };

int main(void)
{
    float *row = calloc(N, sizeof *row);
    row[N - 1] = 3;
    if (mynode() == 0)
        csend(1, row, N * sizeof(float), 1, 0);
    else {
        crecv(1, row, N * sizeof *row);
        printf("%g\n", row[N - 1]);
    }
    free(row);
    return 0;
}
