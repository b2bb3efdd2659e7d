/* permute.c - exercise 2: all nodes send at once. Which messages are in each other's way?
 *
 *    nxcc -g -O2 -o permute permute.c
 *    touchstone run -m ipsc860 -n 64 permute shift
 *
 * Each node sends 10,000 bytes to the node that the permutation (the argument) names, and gets as many from
 * another. Numbers of nodes must be powers of 4. */
#include <stdio.h>
#include <string.h>
#include <nx.h>

enum { DATA = 1, LENGTH = 10000 };

static char out[LENGTH], in[LENGTH];

static int bits(void)
{
    int n = 0;

    while (1L << n < numnodes())
        n++;
    return n;
}

static long reversed(long node)
{
    long other = 0;
    int i;

    for (i = 0; i < bits(); i++)
        other |= (node >> i & 1) << (bits() - 1 - i);
    return other;
}

/* To which node does `node` send? */
static long partner(const char *permutation, long node)
{
    long all = numnodes() - 1;
    int half = bits() / 2;

    if (!strcmp(permutation, "neighbour")) /* the lowest bit changes */
        return node ^ 1;
    if (!strcmp(permutation, "shift")) /* the next node; the last one: node 0 */
        return (node + 1) & all;
    if (!strcmp(permutation, "complement")) /* all bits change */
        return node ^ all;
    if (!strcmp(permutation, "transpose")) /* the upper and the lower half of the bits change places */
        return (node << half | node >> half) & all;
    if (!strcmp(permutation, "reversal")) /* the bits in the opposite order */
        return reversed(node);
    return node;
}

int main(int argc, char **argv)
{
    long to = partner(argc > 1 ? argv[1] : "", mynode()), id;
    double begin, time, work;

    id = irecv(DATA, in, LENGTH);
    gsync(); /* all receives are posted */
    begin = dclock();
    if (to == mynode())
        csend(DATA, out, 0, to, 0); /* nothing to do */
    else
        csend(DATA, out, LENGTH, to, 0);
    msgwait(id);
    time = dclock() - begin;
    gdhigh(&time, 1, &work);
    if (mynode() == 0)
        printf("milliseconds %.3f\n", 1e3 * time);
    return 0;
}
