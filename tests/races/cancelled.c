/* cancelled.c - main uses the buffer of a receive that it no longer wants, and only then withdraws the
 * receive: a message may still come into the buffer.
 * With CORRECT: main withdraws a receive that it no longer wants, and then uses its buffer: no message
 * comes into the buffer any more.
 * variable: scratch */
#include <stdio.h>
#include "nx.h"

enum { HINT = 5, N = 10 };
static long scratch[N];

int main(void)
{
    long id, i, sum = 0;

    if (mynode() == 0) {
        id = irecv(HINT, scratch, sizeof scratch); /* RACE */
#ifdef CORRECT
        msgcancel(id);
#endif
        for (i = 0; i < N; i++)
            scratch[i] = i; /* RACE */
#ifndef CORRECT
        msgcancel(id);
#endif
        for (i = 0; i < N; i++)
            sum += scratch[i];
        printf("sum %ld\n", sum);
    } else {
        csend(HINT, &sum, sizeof sum, 0, 0);
    }
    return 0;
}
