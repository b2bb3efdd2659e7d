/* churn.c - host: loads and kills nodes at odd moments, whatever they are doing. Its argument: how often. */
#include <stdio.h>
#include <stdlib.h>
#include "cube.h"

static long state = 1, bytes[6000], answers;

static long random_below(long n)
{
    state = (state * 1103515245 + 12345) & 0x7fffffff;
    return state / 65536 % n;
}

static void handler(long type, long count, long node, long pid)
{
    (void)type, (void)node, (void)pid;
    answers += count;
    hrecv(70, bytes, sizeof bytes, handler);
}

static void pause_for(double seconds)
{
    double until = dclock() + seconds;
    while (dclock() < until)
        ;
}

int main(int argc, char **argv)
{
    long rounds = argc > 1 ? atol(argv[1]) : 10;
    setpid(1);
    hrecv(70, bytes, sizeof bytes, handler);
    for (long r = 0; r < rounds; r++) {
        getcube("churn", r % 3 ? "8" : "4", "", 0);
        for (long i = 0; i < numnodes(); i++)
            if (random_below(4))
                load("churn_node", i, random_below(3));
        for (long k = 0; k < 6; k++) {
            _csend(1 + random_below(3), bytes, 8 * random_below(3000), random_below(numnodes() + 1) - 1, 0);
            pause_for(1e-3 * (double)random_below(8));
            long i = random_below(numnodes());
            random_below(2) ? killproc(i, -1) : killcube(i, -1);
            if (_load("churn_node", i, 0) < 0)
                printf("node %ld: not loaded\n", i);
        }
        if (r % 2)
            killcube(-1, -1);
        printf("round %ld: %ld bytes at %.6f s\n", r, answers, dclock());
        relcube("churn");
    }
    return 0;
}
