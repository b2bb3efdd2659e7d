/* Complete exchange: every node has a block of m bytes for every other (Bokhari, ICASE Report 91-5, 1991:
 * "Multiphase complete exchange on a circuit switched hypercube"; Nicol & Bokhari, SIGMETRICS 1994).
 *
 *     direct     N - 1 steps: in step i each node exchanges one block with the node me ^ i; no two paths
 *                share an edge
 *     standard   log2 N steps: in step d each node exchanges N / 2 blocks with its neighbour me ^ 2^d, and
 *                shuffles
 *
 * The direct algorithm moves fewer bytes and is faster for long blocks; the standard algorithm sends fewer
 * messages and is faster for short ones. Runs on a power of two of nodes, 128 at most.
 */
#include <string.h>
#include "bench.h"

enum { NODES = 128, LARGEST = 1024, TYPE = 1 };

static const long sizes[] = {4, 8, 16, 32, 64, 96, 128, 192, 256, 320, 384, 448, 512, 640, 768, LARGEST};
static char blocks[NODES * LARGEST], got[NODES * LARGEST], packed[NODES / 2 * LARGEST];

static void direct(long m)
{
    long ids[NODES];
    for (long i = 1; i < numnodes(); i++)
        ids[i] = irecv(TYPE + i, got + (mynode() ^ i) * m, m);
    gsync();
    for (long i = 1; i < numnodes(); i++) {
        csend(TYPE + i, blocks + (mynode() ^ i) * m, m, mynode() ^ i, 0);
        msgwait(ids[i]);
    }
}

/* A block is numbered by its destination and, in the dimensions that it has crossed, by its source. In step d
 * the blocks whose bit d differs from this node's cross dimension d; the blocks received take their
 * numbers. */
static void standard(long m)
{
    long half = numnodes() / 2;
    gsync();
    for (long bit = 1; bit < numnodes(); bit *= 2) {
        long k = 0, id = irecv(TYPE + bit, got, half * m);
        for (long b = 0; b < numnodes(); b++)
            if ((b ^ mynode()) & bit)
                memcpy(packed + k++ * m, blocks + b * m, (size_t)m);
        csend(TYPE + bit, packed, half * m, mynode() ^ bit, 0);
        msgwait(id);
        k = 0;
        for (long b = 0; b < numnodes(); b++)
            if ((b ^ mynode()) & bit)
                memcpy(blocks + b * m, got + k++ * m, (size_t)m);
    }
}

static double time_us(void (*exchange)(long m), long m)
{
    double begin, end, w;
    exchange(m);
    gsync();
    begin = now_us();
    exchange(m);
    end = now_us();
    gdlow(&begin, 1, &w);
    gdhigh(&end, 1, &w);
    return end - begin;
}

int main(void)
{
    double crossover = -1, before = 0;
    for (int i = 0; i < COUNT(sizes); i++) {
        double d = time_us(direct, sizes[i]), s = time_us(standard, sizes[i]), ahead = d - s;
        if (mynode() == 0)
            printf("point direct_%ld %ld %.3f\npoint standard_%ld %ld %.3f\n", numnodes(), sizes[i], d,
                   numnodes(), sizes[i], s);
        if (i > 0 && before > 0 && ahead <= 0)
            crossover = (double)sizes[i] - (double)(sizes[i] - sizes[i - 1]) * ahead / (ahead - before);
        before = ahead;
    }
    if (mynode() == 0)
        figure("crossover_bytes", crossover);
    return 0;
}
