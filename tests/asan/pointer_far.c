/* pointer_far.c - a message is sent from memory of another node, hundreds of nodes away.
 * report: memory-of-another-node: read of 64 bytes, at 0x..., which belongs to node 0
 * run: -n 300 */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

int main(void)
{
    long got[8];
    long *block = calloc(8, sizeof *block);
    if (mynode() == 0)
        csend(1, &block, sizeof block, 299, 0);
    if (mynode() == 299) {
        long *other;
        crecv(1, &other, sizeof other);
#ifdef CORRECT
        other = block;
#endif
        csend(2, other, sizeof got, 1, 0); /* FAULT */
    }
    if (mynode() == 1) {
        crecv(2, got, sizeof got);
        printf("%ld\n", got[7]);
    }
    return 0;
}
