/* Pairs of 64 nodes send each other n bytes at once, as programs of 1995 did: irecv, isend, and msgdone until
 * both are done. */
#include "bench.h"

enum { TYPE = 7, LONG = 131072, ROUNDS = 6 };
static char in[LONG], out[LONG];

static void exchange(long bytes, long other)
{
    long receive = irecv(TYPE, in, bytes), send = isend(TYPE, out, bytes, other, 0);
    while (!msgdone(receive))
        ;
    while (!msgdone(send))
        ;
}

/* The slowest node's mean time of an exchange with six partners. */
static double exchange_ms(long bytes)
{
    double took, work;
    gsync();
    double begin = now_us();
    for (int i = 0; i < ROUNDS; i++)
        exchange(bytes, mynode() ^ (1L << i));
    took = (now_us() - begin) / 1000 / ROUNDS;
    gdhigh(&took, 1, &work);
    return took;
}

int main(void)
{
    double ms[] = {exchange_ms(2048), exchange_ms(16384), exchange_ms(LONG)};
    if (mynode() == 0) {
        figure("exchange_2_ms", ms[0]);
        figure("exchange_16_ms", ms[1]);
        figure("exchange_128_ms", ms[2]);
    }
    return 0;
}
