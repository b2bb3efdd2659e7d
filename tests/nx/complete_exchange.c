/* Complete exchange in log2 N steps of messages of all lengths, long ones among them, with receives posted
 * early and late.
 * run: -m ipsc860 -n 32
 * run: -m delta -n 16
 * run: -m paragon -n 8
 */
#include <nx.h>
#include <stdio.h>
#include <string.h>

enum { NODES = 32, BYTES = 64, TYPE = 1, ROUNDS = 3 };
static char blocks[NODES][BYTES], got[NODES / 2][BYTES], packed[NODES / 2][BYTES];

static void cross(long bit)
{
    long k = 0, id = irecv(TYPE + bit, got, sizeof got);
    for (long b = 0; b < numnodes(); b++)
        if ((b ^ mynode()) & bit)
            memcpy(packed[k++], blocks[b], BYTES);
    csend(TYPE + bit, packed, BYTES * numnodes() / 2, mynode() ^ bit, 0);
    msgwait(id);
    k = 0;
    for (long b = 0; b < numnodes(); b++)
        if ((b ^ mynode()) & bit)
            memcpy(blocks[b], got[k++], BYTES);
}

int main(void)
{
    long wrong = 0, work;
    for (int round = 0; round < ROUNDS; round++) {
        for (long b = 0; b < numnodes(); b++)
            memset(blocks[b], (int)(mynode() + 3 * b), BYTES);
        for (long bit = 1; bit < numnodes(); bit *= 2)
            cross(bit);
        for (long b = 0; b < numnodes(); b++)
            wrong += blocks[b][BYTES - 1] != (char)(b + 3 * mynode());
    }
    gisum(&wrong, 1, &work);
    if (mynode() == 0)
        printf("%ld wrong\n", wrong);
    return 0;
}
