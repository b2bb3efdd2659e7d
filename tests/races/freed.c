/* freed.c - main frees a block before the isend from it is complete; whoever gets the block next writes
 * into the message.
 * With CORRECT: main frees a block when the isend from it is complete.
 * variable: block */
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
        id = isend(BLOCK, block, N * sizeof *block, 1, 0); /* RACE */
#ifdef CORRECT
        msgwait(id);
        free(block);
#else
        free(block); /* RACE */
        msgwait(id);
#endif
    } else {
        crecv(BLOCK, block, N * sizeof *block);
        printf("%ld\n", block[N - 1]);
        free(block);
    }
    return 0;
}
