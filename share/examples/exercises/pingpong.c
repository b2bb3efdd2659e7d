/* pingpong.c - exercise 1: how long does a message take?
 *
 *    nxcc -g -O2 -o pingpong pingpong.c
 *    touchstone run -q -m ipsc860 -n 2 pingpong
 *
 * Nodes 0 and FAR (an argument; default 1) send a message to and fro, 10 times for each length. Node 0
 * prints half of the time of a round trip. */
#include <stdio.h>
#include <stdlib.h>
#include <nx.h>

enum { PING = 1, PONG = 2, TIMES = 10, LONGEST = 8192 };

static char buffer[LONGEST];

static void answer(long length)
{
    int i;

    for (i = 0; i < TIMES; i++) {
        crecv(PING, buffer, length);
        csend(PONG, buffer, length, 0, 0);
    }
}

/* Seconds one way. */
static double measure(long length, long far)
{
    double begin = dclock();
    int i;

    for (i = 0; i < TIMES; i++) {
        csend(PING, buffer, length, far, 0);
        crecv(PONG, buffer, length);
    }
    return (dclock() - begin) / TIMES / 2;
}

int main(int argc, char **argv)
{
    static const long LENGTHS[] = {0, 20, 40, 60, 80, 100, 120, 256, 512, 1024, 2048, 4096, 8192};
    long far = argc > 1 ? atol(argv[1]) : 1;
    size_t i;

    if (mynode() == 0)
        printf("bytes  microseconds\n");
    for (i = 0; i < sizeof LENGTHS / sizeof *LENGTHS; i++) {
        if (mynode() == far)
            answer(LENGTHS[i]);
        if (mynode() == 0)
            printf("%5ld %13.1f\n", LENGTHS[i], 1e6 * measure(LENGTHS[i], far));
    }
    return 0;
}
