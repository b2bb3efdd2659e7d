/* freed_correct.c - main frees a block when the isend from it is complete. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

enum { BLOCK = 5, N = 500 };

int main(void)
{
    long *block = malloc(N * sizeof *block), i, id;

    if (mynode() == 0) {
        for (i = 0; i < N; i++)
            block[i] = i;
        id = isend(BLOCK, block, N * sizeof *block, 1, 0);
        msgwait(id);
        free(block);
    } else {
        crecv(BLOCK, block, N * sizeof *block);
        printf("%ld\n", block[N - 1]);
        free(block);
    }
    return 0;
}
