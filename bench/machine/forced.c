/* Exchanges of messages of forced types, which are sent without rendezvous: node 0 and another node post
 * receives, agree on a time, and then send each other n bytes. The seconds from that time, which the data
 * alone takes, over n and distance.
 *
 *     forced NODE:HOPS...
 */
#include <stdlib.h>
#include <string.h>
#include "bench.h"

enum { DATA = 1, SYNC = 2, FORCED = 1 << 30, ROUNDS = 4, LARGEST = 1 << 16 };

static const long sizes[] = {101, 128, 160, 200, 256, 400, 512, 1024, 4096, 16384, LARGEST};
static char in[LARGEST], out[LARGEST];

/* Both nodes return at one time, within one dclock(); clocks of simulated nodes agree. After an exchange of
 * empty messages only, one node would be ahead by the time of a send. */
static void agree(long other)
{
    double start = dclock() + 1e-3, others;
    csend(SYNC, &start, sizeof start, other, 0);
    crecv(SYNC, &others, sizeof others);
    if (others > start)
        start = others;
    while (dclock() < start)
        ;
}

static double exchange_us(long bytes, long other)
{
    double sum = 0;
    for (int i = 0; i < ROUNDS; i++) {
        long id = irecv(FORCED | DATA, in, bytes);
        agree(other);
        double begin = now_us();
        csend(FORCED | DATA, out, bytes, other, 0);
        msgwait(id);
        sum += now_us() - begin;
    }
    return sum / ROUNDS;
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        char *colon = strchr(argv[i], ':');
        long partner = atol(argv[i]), other = mynode() ? 0 : partner;
        if (mynode() && mynode() != partner)
            continue;
        double sync = exchange_us(0, other);
        if (mynode() == 0 && i == 1)
            figure("sync_us", sync);
        for (int k = 0; k < COUNT(sizes); k++) {
            double us = exchange_us(sizes[k], other);
            if (mynode() == 0)
                printf("point forced_exchange %ld %ld %.3f\n", sizes[k], colon ? atol(colon + 1) : 1, us);
        }
    }
    return 0;
}
