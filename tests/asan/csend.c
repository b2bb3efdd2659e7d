/* csend.c - csend is given a number of bytes that counts in doubles what are floats.
 * report: heap-buffer-overflow: read of 160 bytes, the last 80 of them just behind a block of 80 bytes
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
#ifdef CORRECT
        csend(1, row, N * sizeof(float), 1, 0);
#else
        csend(1, row, N * sizeof(double), 1, 0); /* FAULT */
#endif
    else {
        crecv(1, row, N * sizeof *row);
        printf("%g\n", row[N - 1]);
    }
    free(row);
    return 0;
}
