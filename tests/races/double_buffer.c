/* double_buffer.c - main computes the next block while the last one is being sent, from two buffers in
 * turn, but waits for the wrong send, the last but two: the buffer may still be under way.
 * With CORRECT: main waits for the last send but one: the last from the buffer that it fills.
 * variable: half */
#include <stdio.h>
#include "nx.h"

#ifdef CORRECT
enum { BLOCK = 5, N = 400, BLOCKS = 8, BEHIND = 2 };
#else
enum { BLOCK = 5, N = 400, BLOCKS = 8, BEHIND = 3 };
#endif
static double half[2][N];

int main(void)
{
    long id[BLOCKS], i, b;
    double sum = 0;

    if (mynode() == 0) {
        for (b = 0; b < BLOCKS; b++) {
            if (b >= BEHIND)
                msgwait(id[b - BEHIND]);
            for (i = 0; i < N; i++)
                half[b % 2][i] = b + i;                              /* RACE */
            id[b] = isend(BLOCK, half[b % 2], sizeof half[0], 1, 0); /* RACE */
        }
        for (b = BLOCKS - BEHIND; b < BLOCKS; b++)
            msgwait(id[b]);
    } else {
        for (b = 0; b < BLOCKS; b++) {
            crecv(BLOCK, half[0], sizeof half[0]);
            sum += half[0][N - 1];
        }
        printf("%.0f\n", sum);
    }
    return 0;
}
