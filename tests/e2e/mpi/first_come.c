/* Which worker's results come first decides what node 0 prints: by receives of any node, and by handlers. */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>

enum { RESULT = 1, NEWS = 2, ROUNDS = 40 };

static volatile long news;
static long told, worth;

static void hear(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)pid;
    news = 31 * news % 1000003 + node;
    hrecv(NEWS, &told, sizeof told, hear);
}

/* Takes a time that differs from run to run. */
static void work(long rounds)
{
    volatile double x = 1;
    for (long i = 0; i < rounds; i++)
        x = x * 1.000001 + 1e-9;
}

/* A schedule does not tell where between two calls a handler has run; so none may run while news is read. */
static void tell_news(void)
{
    masktrap(1);
    printf("[%ld] ", news);
    masktrap(0);
}

static void collect(long rounds)
{
    hrecv(NEWS, &told, sizeof told, hear);
    for (long i = 0; i < rounds * (numnodes() - 1); i++) {
        long mid = irecv(RESULT, &worth, sizeof worth);
        flick();
        msgwait(mid);
        worth = infonode();
        printf("%ld%s", worth, i % 30 == 29 ? "\n" : " ");
        if (i % 7 == 3)
            tell_news();
    }
    gsync();
    printf("\nnews %ld\n", news);
}

int main(int argc, char **argv)
{
    long rounds = argc > 1 ? atol(argv[1]) : ROUNDS;
    if (mynode() == 0) {
        collect(rounds);
        return 0;
    }
    for (long i = 0; i < rounds; i++) {
        work(1000 * ((long)(dclock() * 1e7) % 97));
        csend(RESULT, &i, sizeof i, 0, 0);
        if (i % 4 == 0)
            csend(NEWS, &i, sizeof i, 0, 0);
    }
    gsync();
    return 0;
}
