/* two_receives_correct.c - two receives are posted at once for parts of `all` that touch, but do not
 * overlap. */
#include <stdio.h>
#include "nx.h"

enum { LOWER = 5, UPPER = 6, HALF = 50 };
static long all[2 * HALF], mine[HALF + 1];

int main(void)
{
    long lower, upper, i, sum = 0;

    if (mynode() == 0) {
        lower = irecv(LOWER, all, HALF * sizeof *all);
        upper = irecv(UPPER, all + HALF, HALF * sizeof *all);
        msgwait(lower);
        msgwait(upper);
        for (i = 0; i < 2 * HALF; i++)
            sum += all[i];
        printf("sum %ld\n", sum);
    } else {
        for (i = 0; i <= HALF; i++)
            mine[i] = mynode();
        csend(LOWER, mine, HALF * sizeof *mine, 0, 0);
        csend(UPPER, mine, HALF * sizeof *mine, 0, 0);
    }
    return 0;
}
