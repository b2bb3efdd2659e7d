/* deferred_calls.c - deferred_calls WHEN kill|fail|crash|cube: nodes 1 and up send and receive, computing
 * little in between, so that they have deferred calls at most times; node 0 computes for a while, then kills
 * node 1 or all nodes, fails, or crashes. */
#include <stdlib.h>
#include "nx.h"

static char out[3000], in[3000];
static volatile double sum;

static void compute(long turns)
{
    for (long i = 0; i < turns; i++)
        sum += (double)i;
}

static void end(const char *how)
{
    if (*how == 'k')
        killproc(1, 0);
    else if (*how == 'f')
        crecv(-1, NULL, 5);
    else if (how[1] == 'r')
        *(volatile int *)0 = 1;
    else
        killcube(-1, 0);
}

static void talk(long me, long others)
{
    for (int i = 0; i < 12; i++) {
        long id = irecv(50 + i, in, sizeof in);
        csend(1, out, i % 3 ? 8 : 2000, 1 + me % others, 0);
        compute(20 * me);
        csend(50 + i, out, 60, 1 + (me + 1) % others, 0);
        if (i % 4 == 3)
            sum += malloc(1000) != NULL + isend(3, out, 90, 2, 0);
        if (i % 2)
            compute(100);
        if (i % 5 == 4)
            crecv(1, in, sizeof in);
        if (i % 2 == 0)
            msgwait(id);
        for (int k = 0; i % 6 == 5 && k < 3; k++)
            crecv(1, in, sizeof in);
    }
}

int main(int argc, char **argv)
{
    if (argc < 3)
        return 64;
    if (mynode() > 0) {
        talk(mynode(), numnodes() - 1);
    } else {
        compute(atol(argv[1]));
        end(argv[2]);
    }
    return 0;
}
