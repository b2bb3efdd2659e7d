/* served.c - node 0 computes, and serves the others meanwhile by a handler; then it writes a file. */
#include <fcntl.h>
#include <stdio.h>
#include "nx.h"

enum { ASK, ANSWER, DONE, ROUNDS = 20 };

static char request[100], file[20000];
static volatile double sum;

static void work(long rounds)
{
    for (long i = 1; i <= rounds; i++)
        sum += 1.0 / (double)i;
}

static void serve(long type, long count, long node, long pid)
{
    (void)count, (void)pid;
    work(1000);
    csend(ANSWER, request, 10, node, 0);
    hrecv(type, request, sizeof request, serve);
}

static void ask(void)
{
    for (int i = 0; i < ROUNDS; i++) {
        csend(ASK, request, 1, 0, 0);
        crecv(ANSWER, request, sizeof request);
        work(100);
    }
    csend(DONE, request, 0, 0, 0);
}

int main(void)
{
    if (mynode() == 0) {
        hrecv(ASK, request, sizeof request, serve);
        work(200000);
        for (long i = 1; i < numnodes(); i++)
            crecv(DONE, request, sizeof request);
        cwrite(open("/cfs/served", O_CREAT | O_RDWR, 0644), file, sizeof file);
        printf("served %g\n", sum);
    } else {
        ask();
    }
    return 0;
}
