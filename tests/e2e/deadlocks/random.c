/* random.c - random SEED: nodes that send and receive at random, until all wait; most runs end so. */
#include <stdlib.h>
#include "nx.h"

enum { CALLS = 60, TYPES = 4, IDS = 8, BYTES = 16, FORCED = 1 << 30 };

static unsigned long state;
static volatile double sum;
static char out[BYTES], in[BYTES], handled[4][BYTES];
static long ids[IDS], id_count;

static long below(long n)
{
    state = state * 6364136223846793005ul + 1442695040888963407ul;
    return (long)((state >> 33) % (unsigned long)n);
}

static void handle(long type, long count, long node, long pid)
{
    (void)count, (void)pid;
    if (type % 2)
        csend(type / 2, out, BYTES, node, 0);
}

static long other(void)
{
    return (mynode() + 1 + below(numnodes() - 1)) % numnodes();
}

static void compute(long n)
{
    long i;
    for (i = 0; i < n; i++)
        sum += 1.0 / (double)(i + 1);
}

static void receive(void)
{
    long info[8], kind = below(9);
    if (kind < 3)
        crecv(below(TYPES), in, BYTES);
    else if (kind == 3)
        crecv(-1, in, BYTES);
    else if (kind == 4)
        crecvx(below(TYPES), in, BYTES, other(), -1, info);
    else if (kind == 5)
        hrecv(below(TYPES), handled[below(4)], BYTES, handle);
    else if (kind == 6 && id_count < IDS)
        ids[id_count++] = irecv(below(TYPES), in, BYTES);
    else if (kind == 7 && id_count)
        msgwait(ids[--id_count]);
    else
        cprobe(below(TYPES));
}

int main(int argc, char **argv)
{
    int i;

    state = (unsigned long)atol(argv[argc - 1]) * 1000 + (unsigned long)mynode();
    for (i = 0; i < CALLS; i++) {
        long kind = below(40);
        if (kind < 24)
            csend(below(TYPES), out, BYTES, other(), 0);
        else if (kind == 24)
            csend(FORCED + below(TYPES), out, BYTES, other(), 0);
        else if (kind == 25)
            masktrap(below(2));
        else if (kind == 26)
            flushmsg(1, mynode(), 0);
        else if (kind == 27)
            gsync();
        else if (kind < 30)
            compute(below(2000));
        else
            receive();
    }
    gsync();
    return 0;
}
