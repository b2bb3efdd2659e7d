/* gsync.c - the barrier, as a program over the calls of nx.h: the same on every backend.
 *
 * Word that a node has come goes up a spanning tree to node 0, and word that all have comes down by the same tree: two empty
 * messages in each of log2 N steps. In step k nodes that differ in bit k alone are a pair, neighbours on a hypercube; the
 * upper node has heard of all of its subtree by then. With 8 nodes:
 *
 *     up     1 -> 0   3 -> 2   5 -> 4   7 -> 6         1st
 *            2 -> 0            6 -> 4                  2nd
 *            4 -> 0                                    3rd
 *     down   the same arrows the other way, in the other order
 *
 * Source: 150 us a dimension on the iPSC/860 (known: Bokhari 1991), which is two of its empty messages of 75 us, one after the
 * other; an exchange would take little more than one. Nodes leave at different times, as Intel's gsync let them (read: abstract
 * of Seidel and Davis, A Global Synchronization Algorithm for the Intel iPSC/860, 1992). That it was this tree is derived.
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
