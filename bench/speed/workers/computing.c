/* computing.c - computing PATTERN MICROSECONDS ROUNDS: an NX program that gains little or nothing from
 * workers. A round is
 *
 *   turns    nodes 0 and 1: node 0 computes, then node 1
 *   armed    every node: computes with a handler posted, and sends a message to the next node's handler
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"

static volatile double sink;

static void compute(long steps)
{
    double x = 0.5;
    for (long i = 0; i < steps; i++)
        x = x * 0.999 + 0.001;
    sink = x;
}

static long steps_of(double seconds)
{
    enum { TRY = 10000 };
    double start = dclock();
    compute(TRY);
    return (long)(seconds * TRY / (dclock() - start));
}

static void turn(long steps)
{
    char message[8] = "";
    if (mynode() == 1)
        crecv(1, message, sizeof message);
    compute(steps);
    csend(1, message, sizeof message, !mynode(), 0);
    if (mynode() == 0)
        crecv(1, message, sizeof message);
}

static char news[8];

static void on_news(long type, long count, long node, long pid)
{
    (void)count, (void)node, (void)pid;
    hrecv(type, news, sizeof news, on_news);
}

static void armed(long steps)
{
    static const char message[8];
    compute(steps);
    csend(1, message, sizeof message, (mynode() + 1) % numnodes(), 0);
}

int main(int argc, char **argv)
{
    double seconds = argc == 4 ? 1e-6 * atof(argv[2]) : 0;
    int turns = argc == 4 && !strcmp(argv[1], "turns");
    if (seconds <= 0 || (!turns && strcmp(argv[1], "armed"))) {
        fputs("usage: computing turns|armed MICROSECONDS ROUNDS\n", stderr);
        return 64;
    }
    long steps = steps_of(seconds), rounds = atol(argv[3]);
    if (!turns)
        hrecv(1, news, sizeof news, on_news);
    for (long i = 0; i < rounds; i++)
        (turns ? turn : armed)(steps);
    gsync();
    return 0;
}
