/* Selection is by type alone, so programs put the sender's number into it: node * 32768 and something, below
 * 2^30. Messages that come in any order are received in the order of the nodes.
 * run: all
 */
#include "rule.h"

int main(void)
{
    long me = mynode(), nodes = numnodes(), x = me, y;
    int good = 1;
    for (long i = 0; i < nodes; i++)
        csend(me * 32768 + 17, &x, sizeof x, (me + i) % nodes, 0);
    for (long i = nodes - 1; i >= 0; i--) {
        crecv(i * 32768 + 17, &y, sizeof y);
        good = good && y == i && infonode() == i && infotype() == i * 32768 + 17;
    }
    rule("each from its sender", good);
    csend((1 << 30) - 32768 + 5 < 1000000000 ? (1 << 30) - 32768 + 5 : 999999999, &x, sizeof x, me, 0);
    crecv(999999999, &y, sizeof y);
    rule("the largest type", y == me);
    return 0;
}
