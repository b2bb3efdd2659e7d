/* own_data.c - every node counts its calls; node 0, whose handler counts, too, does so without masktrap.
 * With CORRECT: main counts on node 1 and the handler on node 0. Each node has a variable of its own by
 * this name.
 * variable: calls */
#include <stdio.h>
#include "nx.h"

enum { CALL = 5, END = 6, CALLS = 5 };
static long calls;

static void on_call(long type, long count, long node, long pid)
{
    calls++; /* RACE */
    hrecv(CALL, NULL, 0, on_call);
}

int main(void)
{
    int i;

    if (mynode() == 0)
        hrecv(CALL, NULL, 0, on_call);
    for (i = 0; i < CALLS; i++) {
        if (mynode() == 1)
            csend(CALL, NULL, 0, 0, 0);
#ifdef CORRECT
        if (mynode() == 1)
            calls++;
#else
        calls++; /* RACE */
#endif
    }
    gsync();
    if (mynode() == 1)
        printf("%ld\n", calls);
    return 0;
}
