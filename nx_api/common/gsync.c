/* gsync.c - the barrier, made of calls of nx.h: the same on every back end.
 *
 * Empty messages go up a spanning tree to node 0, each saying that a subtree has come, and down the same
 * tree, saying that all have come: two messages in each of log2 N steps. In step k nodes whose numbers differ
 * only in bit k are a pair, neighbours on a hypercube; by then the upper node has heard of its whole subtree.
 * With 8 nodes:
 *
 *     up     1 -> 0   3 -> 2   5 -> 4   7 -> 6         1st
 *            2 -> 0            6 -> 4                  2nd
 *            4 -> 0                                    3rd
 *     down   the same arrows the other way, in the other order
 *
 * Source: 150 us a dimension on the iPSC/860 (known: Bokhari 1991) are two of its empty messages of 75 us,
 * one after the other; an exchange would take little more than one. Nodes leave at different times, as
 * Intel's gsync let them (read: abstract of Seidel and Davis, A Global Synchronization Algorithm for the
 * Intel iPSC/860, 1992). The tree is derived from the two.
 */
#include "global.h"
#include "nx.h"

enum { UP, DOWN };

static void tell(long way, long node)
{
    csend(GLOBAL_FIRST_TYPE + GSYNC * GLOBAL_TYPES + way, NULL, 0, node, 0);
}

static void hear(long way)
{
    crecv(GLOBAL_FIRST_TYPE + GSYNC * GLOBAL_TYPES + way, NULL, 0);
}

void gsync(void)
{
    long me = mynode(), nodes = numnodes(), bit = 1;
    for (; bit < nodes && !(me & bit); bit *= 2)
        if (me + bit < nodes)
            hear(UP);
    if (me) {
        tell(UP, me - bit);
        hear(DOWN);
    }
    for (bit /= 2; bit > 0; bit /= 2)
        if (me + bit < nodes)
            tell(DOWN, me + bit);
}
