/* sent.c - a message is sent from an array that is gone.
 * report: stack-use-after-return: read of 64 bytes, where a function that has returned had its variables
 * run: -n 2 */
#include <stdio.h>
#include "nx.h"

static long *kept; /* so that GCC does not see what it points at */

static __attribute__((noinline)) void fill(long *all)
{
    long i;
    for (i = 0; i < 8; i++)
        all[i] = i;
    kept = all;
}

static __attribute__((noinline)) void make(void)
{
#ifdef CORRECT
    static long all[8];
#else
    long all[8];
#endif
    fill(all);
}

int main(void)
{
    long got[8] = {0};
    if (mynode() == 0) {
        make();
        csend(1, kept, sizeof got, 1, 0); /* FAULT */
    } else {
        crecv(1, got, sizeof got);
    }
    printf("%ld\n", got[7]);
    return 0;
}
