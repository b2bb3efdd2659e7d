/* tie.c - two nodes at the same distance send to the node between them at the same time. It counts on the
 * lower one's message to come first.
 *
 * bad outcome: wrong output, when node 2's message comes first
 * depth: 1 (node 2's message < node 0's)      nodes: 3, in one row (mesh)
 * good: the line "1 from the left, 2 from the right"
 * delay: node 0's message by any time; or the other order of simultaneous events */
#include <stdio.h>
#include "nx.h"
#include "work.h"

enum { SIDE = 5 };

int main(void)
{
    long me = mynode(), left, right, side = 1 + me / 2;

    if (me == 1) {
        crecv(SIDE, &left, sizeof left);
        crecv(SIDE, &right, sizeof right);
        printf("%ld from the left, %ld from the right\n", left, right);
    } else {
        if (me == 0)
            late(1);
        csend(SIDE, &side, sizeof side, 1, 0);
    }
    return 0;
}
