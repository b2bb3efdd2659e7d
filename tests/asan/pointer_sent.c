/* pointer_sent.c - a pointer comes by a message, from the node whose memory it points to.
 * report: memory-of-another-node: write of 4 bytes, at 0x..., which belongs to node 0
 * run: -n 2 */
#include <stdio.h>
#include "nx.h"

static int all[4];

int main(void)
{
    int *first = all;
    if (mynode() == 0) {
        csend(1, &first, sizeof first, 1, 0);
    } else {
        crecv(1, &first, sizeof first);
#ifdef CORRECT
        first = all;
#endif
        first[1] = 7; /* FAULT */
    }
    gsync();
    printf("%d\n", all[1]);
    return 0;
}
