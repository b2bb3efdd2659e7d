/* many.c - a ring of nodes with many short intervals: the timeline's load in tests/e2e/page.sh. */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>

static double relaxed;

__attribute__((noinline)) static void relax(int rounds)
{
    for (int i = 0; i < rounds; i++)
        relaxed = (relaxed + i) * 0.5;
}

int main(int argc, char **argv)
{
    long me = mynode(), nodes = numnodes(), rounds = argc > 1 ? atol(argv[1]) : 100, token = me;
    for (long k = 0; k < rounds; k++) {
        csend(5, &token, sizeof token, (me + 1) % nodes, 0);
        relax(50 + (int)(me * 7 + k) % 40);
        crecv(5, &token, sizeof token);
    }
    long id = irecv(6, &token, sizeof token);
    csend(6, &me, sizeof me, (me + 1) % nodes, 0);
    msgwait(id);
    gsync();
    if (me == 0)
        printf("rounds %ld\n", rounds);
    return 0;
}
