/* two_receives.c - two receives are posted at once for parts of `all` that overlap by one element: which
 * message is there in the end is left to chance.
 * With CORRECT: two receives are posted at once for parts of `all` that touch, but do not overlap.
 * variable: all */
#include <stdio.h>
#include "nx.h"

enum { LOWER = 5, UPPER = 6, HALF = 50 };
static long all[2 * HALF], mine[HALF + 1];

int main(void)
{
    long lower, upper, i, sum = 0;

    if (mynode() == 0) {
#ifdef CORRECT
        lower = irecv(LOWER, all, HALF * sizeof *all);
#else
        lower = irecv(LOWER, all, (HALF + 1) * sizeof *all); /* RACE */
#endif
        upper = irecv(UPPER, all + HALF, HALF * sizeof *all); /* RACE */
        msgwait(lower);
        msgwait(upper);
        for (i = 0; i < 2 * HALF; i++)
            sum += all[i];
        printf("sum %ld\n", sum);
    } else {
        for (i = 0; i <= HALF; i++)
            mine[i] = mynode();
#ifdef CORRECT
        csend(LOWER, mine, HALF * sizeof *mine, 0, 0);
#else
        csend(LOWER, mine, (HALF + 1) * sizeof *mine, 0, 0);
#endif
        csend(UPPER, mine, HALF * sizeof *mine, 0, 0);
    }
    return 0;
}
