/* merged.c - main posts two receives and waits for the first only before it uses both buffers.
 * With CORRECT: main waits for both, by one merged message id, before it uses the buffers.
 * variable: right */
#include <stdio.h>
#include "nx.h"

enum { LEFT = 5, RIGHT = 6, N = 8 };
static double left[N], right[N];

int main(void)
{
    long a, b;
    int i;

    if (mynode() == 0) {
        a = irecv(LEFT, left, sizeof left);
        b = irecv(RIGHT, right, sizeof right); /* RACE */
#ifdef CORRECT
        a = msgmerge(a, b);
#endif
        msgwait(a);
        for (i = 0; i < N; i++)
            left[i] += right[i]; /* RACE */
#ifndef CORRECT
        msgwait(b);
#endif
        printf("%g\n", left[0]);
    } else {
        for (i = 0; i < N; i++)
            left[i] = right[i] = i;
        csend(RIGHT, right, sizeof right, 0, 0);
        csend(LEFT, left, sizeof left, 0, 0);
    }
    return 0;
}
